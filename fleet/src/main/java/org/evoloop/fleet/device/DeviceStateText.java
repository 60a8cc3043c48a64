package org.evoloop.fleet.device;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.SnapshotException;
import org.evoloop.engine.codec.SnapshotText;
import org.jspecify.annotations.Nullable;

/**
 * The text of {@link DeviceState}, in UTF-8: one line, then the snapshot's text.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class DeviceStateText {
    private static final String TITLE = "evoloop-device 1 ";
    private static final int WORDS = 11;

    private DeviceStateText() {}

    /**
     * The version of the models in {@code bytes}.
     *
     * @throws IllegalArgumentException if they are not such a text, or have another format version
     */
    public static String model(byte[] bytes) {
        int end = 0;
        while (end < bytes.length && bytes[end] != '\n') {
            end++;
        }
        return head(new String(bytes, 0, Math.min(bytes.length, end + 1), StandardCharsets.UTF_8))[0];
    }

    /**
     * Parses {@code bytes}.
     *
     * @param rules the rules of the version given by {@link #model}
     * @throws IllegalArgumentException if they are not such a text
     * @throws SnapshotException if they name something that the models lack
     */
    public static DeviceState read(Rules rules, byte[] bytes) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        String[] words = head(text);
        try {
            return new DeviceState(
                    words[0],
                    Long.parseLong(words[1]),
                    Long.parseLong(words[2]),
                    order(words, 3),
                    order(words, 7),
                    SnapshotText.read(rules, text.substring(text.indexOf('\n') + 1)));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("line 1: " + e.getMessage(), e);
        }
    }

    private static String[] head(String text) {
        int end = text.indexOf('\n');
        String[] words = text.startsWith(TITLE) && end > 0
                ? text.substring(TITLE.length(), end).split(" ", -1)
                : new String[0];
        if (words.length != WORDS) {
            throw new IllegalArgumentException("'" + TITLE + "' and " + WORDS + " words were expected");
        }
        return words;
    }

    private static Order.@Nullable Open order(String[] words, int at) {
        long sequence = Long.parseLong(words[at]);
        return sequence == 0
                ? null
                : new Order.Open(
                        sequence,
                        Long.parseLong(words[at + 1]),
                        Order.Kind.valueOf(words[at + 2].toUpperCase(Locale.ROOT)),
                        Long.parseLong(words[at + 3]));
    }
}
