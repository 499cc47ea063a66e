package raytracer.files;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The files that one run of the program reads and writes: none that it writes may be another of them, by any name. */
public final class Places {

    private record Claim(Path file, String what, boolean isWritten) {
        @Override
        public String toString() {
            return what + " (" + file + ")";
        }
    }

    private final List<Claim> claims = new ArrayList<>();

    /**
     * @param file null for none
     * @param what it is, for messages
     */
    public void read(Path file, String what) throws UsageException, IOException {
        add(new Claim(file, what, false));
    }

    /**
     * @param file null for none
     * @param what it is, for messages
     */
    public void write(Path file, String what) throws UsageException, IOException {
        add(new Claim(file, what, true));
    }

    private void add(Claim claim) throws UsageException, IOException {
        if (claim.file == null) {
            return;
        }
        for (Claim other : claims) {
            if ((claim.isWritten || other.isWritten) && areSame(claim.file, other.file)) {
                Claim written = claim.isWritten ? claim : other, kept = claim.isWritten ? other : claim;
                throw new UsageException(written + " would replace " + kept);
            }
        }
        claims.add(claim);
    }

    /** What is no regular file, as {@code /dev/null}, holds nothing that could be replaced. */
    private static boolean areSame(Path a, Path b) throws IOException {
        if (OutputFile.isDevice(a) || OutputFile.isDevice(b)) {
            return false;
        }
        return Files.exists(a) && Files.exists(b) ? Files.isSameFile(a, b) : real(a).equals(real(b));
    }

    private static Path real(Path file) throws IOException {
        Path place = OutputFile.place(file);
        Path folder = OutputFile.folder(place);
        return (Files.isDirectory(folder) ? folder.toRealPath() : folder.normalize()).resolve(place.getFileName());
    }
}
