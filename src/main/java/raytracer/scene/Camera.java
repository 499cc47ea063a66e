package raytracer.scene;

/**
 * A pinhole camera.
 *
 * @param eye where rays start
 * @param at  the point in the middle of the picture, not {@code eye}
 * @param up  not parallel to the view
 * @param fov vertical field of view in degrees, strictly between 0 and 180
 */
public record Camera(Vector eye, Vector at, Vector up, double fov) {

    /**
     * The least sine of the angle between {@code up} and the view, times the length of {@code up}. Below it the cross
     * product that gives the picture's horizontal is made of rounding errors (a few 1e-16), and the picture would roll
     * at random.
     */
    private static final double MIN_UP_SINE = 1e-12;

    /** Points backwards, from what is looked at to the eye. */
    public Vector backward() {
        return eye.minus(at).unit();
    }

    /** Points to the picture's right. */
    public Vector right() {
        return up.unit().cross(backward()).unit();
    }

    /** Whether {@code up} says which way is up: it is neither zero nor parallel to the view. */
    public boolean upIsClear() {
        return up.unit().cross(backward()).length() > MIN_UP_SINE;
    }
}
