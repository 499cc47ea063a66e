package raytracer.image;

import java.awt.Rectangle;
import java.awt.image.ColorModel;
import java.awt.image.Raster;
import java.awt.image.RenderedImage;
import java.awt.image.SampleModel;
import java.awt.image.WritableRaster;
import java.util.Vector;

/**
 * An {@link Image} as an encoder sees it: each row is its own tile, and there when all of it has been set. Not a
 * {@link java.awt.image.BufferedImage}, for of that Java 25's encoder takes the bytes without asking.
 */
record PendingRows(Image image, WritableRaster raster) implements RenderedImage {

    @Override
    public Raster getData(Rectangle area) {
        for (int row = area.y; row < area.y + area.height; row++) {
            image.awaitRow(row);
        }
        return raster.createChild(area.x, area.y, area.width, area.height, area.x, area.y, null);
    }

    @Override
    public Raster getData() {
        return getData(raster.getBounds());
    }

    @Override
    public Raster getTile(int x, int y) {
        return getData(new Rectangle(0, y, getWidth(), 1));
    }

    @Override
    public WritableRaster copyData(WritableRaster to) {
        WritableRaster copy = to != null ? to : raster.createCompatibleWritableRaster();
        copy.setRect(getData());
        return copy;
    }

    @Override
    public ColorModel getColorModel() {
        return Rgb.colours();
    }

    @Override
    public SampleModel getSampleModel() {
        return raster.getSampleModel();
    }

    @Override
    public int getWidth() {
        return image.width();
    }

    @Override
    public int getHeight() {
        return image.height();
    }

    @Override
    public int getTileWidth() {
        return getWidth();
    }

    @Override
    public int getTileHeight() {
        return 1;
    }

    @Override
    public int getNumXTiles() {
        return 1;
    }

    @Override
    public int getNumYTiles() {
        return getHeight();
    }

    @Override
    public int getMinX() {
        return 0;
    }

    @Override
    public int getMinY() {
        return 0;
    }

    @Override
    public int getMinTileX() {
        return 0;
    }

    @Override
    public int getMinTileY() {
        return 0;
    }

    @Override
    public int getTileGridXOffset() {
        return 0;
    }

    @Override
    public int getTileGridYOffset() {
        return 0;
    }

    @Override
    public Vector<RenderedImage> getSources() {
        return null;
    }

    @Override
    public Object getProperty(String name) {
        return java.awt.Image.UndefinedProperty;
    }

    @Override
    public String[] getPropertyNames() {
        return null;
    }
}
