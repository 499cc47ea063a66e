package raytracer.parser;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * Cuts a stream into lines, in place: one buffer that holds at least the current line, nothing allocated per line.
 * The byte behind a line is always a line feed, so that scanning loops need no other end.
 */
final class LineReader {

    /** In bytes. Far more than any command needs, and little enough that a file without line breaks does no harm. */
    static final int LONGEST_LINE = 1 << 20;

    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};

    private final InputStream in;
    private int filled;
    private int next;

    byte[] buffer = new byte[1 << 16];

    // Where the current line starts in the buffer; and behind its last byte, where a line feed stands.
    int start;
    int end;

    /** The current line's number, from 1; 0 before the first. */
    long number;

    /** Whether reading stopped at a line of more than {@link #LONGEST_LINE} bytes. */
    boolean isTooLong;

    LineReader(InputStream in) {
        this.in = in;
    }

    /** Goes to the next line; false if there is none, or if it is too long to be read. */
    boolean advance() throws IOException {
        start = next;
        int at = start;
        while (true) {
            byte[] bytes = buffer;
            while (at < filled && bytes[at] != '\n' && bytes[at] != '\r') {
                at++;
            }
            if (at < filled) {
                return settle(at - start);
            }
            int length = filled - start;
            if (length >= LONGEST_LINE) {
                isTooLong = true;
                number++;
                end = start;
                return false;
            }
            if (!fill()) {
                end = filled;
                return length > 0 && settle(length);
            }
            at = start + length;
        }
    }

    /** The line ends at a line feed, at a carriage return, or at both. */
    private boolean settle(int length) throws IOException {
        if (start + length + 1 == filled && buffer[start + length] == '\r') {
            fill();
        }
        end = start + length;
        next = Math.min(filled, end + 1);
        if (next < filled && buffer[end] == '\r' && buffer[next] == '\n') {
            next++;
        }
        buffer[end] = '\n';
        if (++number == 1 && Arrays.equals(buffer, start, Math.min(start + 3, end), BYTE_ORDER_MARK, 0, 3)) {
            start += BYTE_ORDER_MARK.length;
        }
        return true;
    }

    /** Reads more behind what is there; false at the end of the stream. Always leaves room for a line feed. */
    private boolean fill() throws IOException {
        if (start > 0) {
            System.arraycopy(buffer, start, buffer, 0, filled - start);
            filled -= start;
            next -= start;
            start = 0;
        }
        if (filled + 1 == buffer.length) {
            buffer = Arrays.copyOf(buffer, 2 * buffer.length);
        }
        int read = in.readNBytes(buffer, filled, buffer.length - 1 - filled);
        filled += read;
        return read > 0;
    }
}
