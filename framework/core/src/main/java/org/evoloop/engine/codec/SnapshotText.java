package org.evoloop.engine.codec;

import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;

/**
 * Snapshots as text: one item per line, words and numbers bare, names in quotes. The same snapshot gives the same text.
 *
 * <p>States and transitions are written by name and looked up again, so that a text outlives the models' objects, and
 * relevant changes of the models are detected. Texts of another version are refused.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class SnapshotText {
    /** The first word of the first line; the version follows. */
    static final String TITLE = "evoloop-snapshot";

    /** The version of the format. */
    public static final int VERSION = 2;

    private SnapshotText() {}

    /** The text of {@code snapshot}, in lines that each end in a line feed. */
    public static String write(Snapshot snapshot) {
        LineWriter writer = new LineWriter();
        writer.begin(TITLE).number(VERSION).end();
        new SnapshotWriter(writer).write(snapshot);
        return writer.written();
    }

    /**
     * Parses a snapshot.
     *
     * @param rules the rules, with the models to which the named states and transitions belong
     * @throws CodecException if it is not such a text, is of another version, or names something that the models do
     *     not have
     */
    public static Snapshot read(Rules rules, String text) {
        Lines lines = new Lines(text);
        requireVersion(lines);
        return new SnapshotReader(rules.table().models(), lines).read();
    }

    private static void requireVersion(Lines lines) {
        if (!lines.next().equals(TITLE)) {
            throw lines.wrong("this is not a snapshot of Evoloop", "its first line is '" + TITLE + " " + VERSION + "'");
        }
        long version = lines.number();
        lines.ends();
        if (version != VERSION) {
            throw lines.wrong(
                    "version " + version + " cannot be read, only version " + VERSION,
                    "use the version of Evoloop that wrote it, or start without it");
        }
    }
}
