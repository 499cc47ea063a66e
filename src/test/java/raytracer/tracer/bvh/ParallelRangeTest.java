package raytracer.tracer.bvh;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@DisplayName("Work in halves")
class ParallelRangeTest {

    @ParameterizedTest(name = "is done once for each of {0} numbers on {1} threads")
    @CsvSource({"0, 1", "1, 2", "32767, 2", "32768, 2", "100003, 1", "100003, 3"})
    void isDoneOnceForEach(int count, int threads) {
        int first = 5;
        AtomicIntegerArray done = new AtomicIntegerArray(first + count);
        ForkJoinPool pool = new ForkJoinPool(threads);
        ParallelRange.run(pool, first, first + count, (from, to) -> {
            for (int i = from; i < to; i++) {
                done.incrementAndGet(i);
            }
        });
        pool.shutdown();
        for (int i = 0; i < first + count; i++) {
            assertEquals(i < first ? 0 : 1, done.get(i), "number " + i);
        }
    }
}
