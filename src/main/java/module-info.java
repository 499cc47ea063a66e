/** A program, not a library: nothing is exported, so what one of its packages shows another stays inside. */
module raytracer {
    requires java.desktop;
}
