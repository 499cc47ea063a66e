package raytracer.parser;

import java.util.List;

/** Finds the word that was meant. */
public final class Spelling {

    /** Typing errors that are forgiven. */
    private static final int MAX_EDITS = 2;

    private Spelling() { }

    /** The word that is closest to what was written; null if none is close. */
    public static String nearest(String written, List<String> words) {
        String best = null;
        int min = MAX_EDITS + 1;
        for (String word : words) {
            int edits = edits(written, word);
            if (edits < min && edits < word.length() - 1) {
                min = edits;
                best = word;
            }
        }
        return best;
    }

    /** The Levenshtein distance, or more than {@link #MAX_EDITS} if the lengths alone say so. */
    private static int edits(String a, String b) {
        if (Math.abs(a.length() - b.length()) > MAX_EDITS) {
            return MAX_EDITS + 1;
        }
        int[] above = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            above[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] row = new int[b.length() + 1];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = above[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                row[j] = Math.min(replaced, 1 + Math.min(above[j], row[j - 1]));
            }
            above = row;
        }
        return above[b.length()];
    }
}
