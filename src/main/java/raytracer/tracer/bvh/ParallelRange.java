package raytracer.tracer.bvh;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveAction;

/** The same work for many numbers, halved until each thread of a pool has its part. */
public final class ParallelRange extends RecursiveAction {

    private static final long serialVersionUID = 1;

    /** Fewer numbers than this are not worth another task. */
    private static final int PARALLEL_SIZE = 1 << 15;

    private final transient Work work;
    private final int from;
    private final int to;

    /** What is to be done for numbers {@code from} to {@code to - 1}; the parts must not disturb one another. */
    public interface Work {
        void over(int from, int to);
    }

    private ParallelRange(Work work, int from, int to) {
        this.work = work;
        this.from = from;
        this.to = to;
    }

    /** Returns when all is done. */
    public static void run(ForkJoinPool pool, int from, int to, Work work) {
        if (to - from < PARALLEL_SIZE) {
            work.over(from, to);
        } else {
            pool.invoke(new ParallelRange(work, from, to));
        }
    }

    @Override
    protected void compute() {
        if (to - from < PARALLEL_SIZE) {
            work.over(from, to);
        } else {
            int middle = (from + to) >>> 1;
            invokeAll(new ParallelRange(work, from, middle), new ParallelRange(work, middle, to));
        }
    }
}
