package raytracer.tracer.lightbuffer;

import java.util.ArrayDeque;
import java.util.Deque;

/** Numbers to be taken again in the order in which they were added, all of them after the last was; any number. */
public final class IntQueue {

    /** Small enough that the garbage collector treats a part as it treats any object. */
    private static final int PART = 1 << 16;

    private final Deque<int[]> parts = new ArrayDeque<>();

    // What is added to, and then what is taken from.
    private int[] part = new int[PART];
    private int at;
    private int countInLast = -1;

    void add(int number) {
        if (at == PART) {
            parts.add(part);
            part = new int[PART];
            at = 0;
        }
        part[at++] = number;
    }

    /** Whether there is more to take. */
    boolean isLeft() {
        if (countInLast < 0) {
            countInLast = at;
            parts.add(part);
            part = parts.remove();
            at = 0;
        }
        return !parts.isEmpty() || at < countInLast;
    }

    /** The next one. */
    int take() {
        if (at == PART) {
            part = parts.remove();
            at = 0;
        }
        return part[at++];
    }
}
