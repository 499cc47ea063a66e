package raytracer.tracer.lightbuffer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@DisplayName("A tape")
class IntQueueTest {

    @ParameterizedTest(name = "gives back {0} numbers in their order, and no more")
    @ValueSource(ints = {0, 1, 65_535, 65_536, 65_537, 131_072, 200_000})
    void givesBackWhatWasAdded(int count) {
        IntQueue tape = new IntQueue();
        for (int i = 0; i < count; i++) {
            tape.add(i * 0x9E3779B1);
        }
        for (int i = 0; i < count; i++) {
            assertTrue(tape.isLeft());
            assertEquals(i * 0x9E3779B1, tape.take());
        }
        assertFalse(tape.isLeft());
    }
}
