package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A word of a property.
 *
 * <p>Threading: immutable.
 *
 * @param quoted whether it is in quotation marks, and so is a name, whatever its text
 * @since 0.1
 */
public record Word(String text, boolean quoted) {
    private static final Pattern WORD = Pattern.compile("\\(|\\)|\"([^\"]*)\"|[^\\s()\"]+");

    /** The words of {@code text}, in order; each bracket is one. */
    public static List<Word> of(String text) {
        List<Word> words = new ArrayList<>();
        for (Matcher matcher = WORD.matcher(text); matcher.find(); ) {
            String quoted = matcher.group(1);
            words.add(quoted != null ? new Word(quoted, true) : new Word(matcher.group(), false));
        }
        return List.copyOf(words);
    }

    /** Whether it is {@code keyword} and not a name. */
    public boolean is(String keyword) {
        return !quoted && text.equals(keyword);
    }
}
