package raytracer.render;

import java.awt.image.BufferedImage;

/**
 * How two pictures of one size differ.
 *
 * @param pixels  how many do
 * @param worst   the greatest difference of a component, of 255
 * @param x       where that is
 * @param y       where that is
 * @param picture the differences, times ten
 */
record Difference(int pixels, int worst, int x, int y, BufferedImage picture) {

    static Difference between(BufferedImage a, BufferedImage b) {
        BufferedImage picture = new BufferedImage(a.getWidth(), a.getHeight(), BufferedImage.TYPE_INT_RGB);
        int pixels = 0, worst = 0, worstX = 0, worstY = 0;
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                int greatest = 0, shown = 0;
                for (int shift = 0; shift < 24; shift += 8) {
                    int d = Math.abs((a.getRGB(x, y) >> shift & 255) - (b.getRGB(x, y) >> shift & 255));
                    greatest = Math.max(greatest, d);
                    shown |= Math.min(255, 10 * d) << shift;
                }
                picture.setRGB(x, y, shown);
                pixels += greatest > 0 ? 1 : 0;
                if (greatest > worst) {
                    worst = greatest;
                    worstX = x;
                    worstY = y;
                }
            }
        }
        return new Difference(pixels, worst, worstX, worstY, picture);
    }

    @Override
    public String toString() {
        return pixels + " pixels differ, the most by " + worst + " at (" + x + ", " + y + ")";
    }
}
