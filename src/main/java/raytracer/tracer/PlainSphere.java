package raytracer.tracer;

/** What is plain of rays and a sphere when its perpendiculars to them are known; the others need a closer look. */
final class PlainSphere {

    private PlainSphere() { }

    /**
     * Takes what is met clearly, and nearer than all before; lists the rays that need a closer look.
     *
     * @param clear a ray of which the square of half the chord, as it were, is less than this does not meet the sphere
     */
    record TakeNearer(Rays rays, double clear, int slot, Scratch scratch) implements Pass {
        @Override
        public void run(int from, int to) {
            double[] distance = rays.distance, along = scratch.along, square = scratch.square, t = scratch.distance;
            int[] hit = rays.hit, doubtful = scratch.doubtful;
            int count = 0;
            for (int i = from; i < to; i++) {
                if (square[i] >= 0) {
                    if (along[i] < 0 && t[i] <= distance[i] * (1 + Rounding.TIE_SIEVE)) {
                        if (t[i] < distance[i] * (1 - Rounding.TIE_SIEVE)) {
                            hit[i] = slot;
                            distance[i] = t[i];
                        } else {
                            doubtful[count++] = i;
                        }
                    }
                } else if (square[i] >= clear) {
                    doubtful[count++] = i;
                }
            }
            scratch.doubtfulCount = count;
        }
    }

    /**
     * Closes the ways to a lamp that are blocked for certain; lists the rays that need a closer look.
     *
     * @param radius   of the sphere
     * @param lampSide 1 if the lamp is outside of it, -1 inside, 0 on it
     */
    record Close(Rays rays, ShadowRays shadows, double radius, double clear, int slot, int lampSide, Scratch scratch)
            implements Pass {
        @Override
        public void run(int from, int to) {
            double[] square = scratch.square, along = scratch.along, distance = shadows.distance;
            double[] originError = rays.originError;
            boolean[] open = shadows.open;
            int[] hit = rays.hit, doubtful = scratch.doubtful;
            int count = 0;
            for (int i = from; i < to; i++) {
                if (square[i] >= clear && open[i]) {
                    boolean behind = along[i] >= 0;
                    boolean plain = hit[i] == slot ? behind : (behind || square[i] >= 0) && lampSide >= 0
                            && startsOutside(along[i], square[i], radius, originError[i]);
                    if (!plain) {
                        doubtful[count++] = i;
                    } else if (!behind && -along[i] < distance[i]) {
                        open[i] = false;
                    }
                }
            }
            scratch.doubtfulCount = count;
        }

        /** Whether a ray clearly starts outside a sphere that it meets, or does not pass by far. */
        private static boolean startsOutside(double along, double square, double r, double originError) {
            double power = along * along - square;
            return power > Rounding.power(originError, r) + Rounding.passingPower(along * along, r * r);
        }
    }
}
