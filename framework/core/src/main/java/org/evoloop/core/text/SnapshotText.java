package org.evoloop.core.text;

import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;

/**
 * Snapshots as text: one thing in a line, words and numbers bare, names in quotes. The same snapshot gives the same text.
 *
 * <p>States and transitions are written by name and looked up again, so that a text outlives the models' objects, and
 * models that were changed meanwhile are noticed where that matters. Texts of another version are refused.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class SnapshotText {
    /** How the first line begins; the version follows. */
    static final String TITLE = "evoloop-snapshot";

    /** The version that is written and read. */
    public static final int VERSION = 2;

    private SnapshotText() {}

    /** The text of {@code snapshot}, in lines that each end in a line feed. */
    public static String write(Snapshot snapshot) {
        return new SnapshotWriter().write(snapshot);
    }

    /**
     * The snapshot that a text describes.
     *
     * @param rules whose models have the states and transitions that are named
     * @throws SnapshotException if it is no such text, of another version, or names what the models do not have
     */
    public static Snapshot read(Rules rules, String text) {
        return new SnapshotReader(rules.table().models(), new Lines(text)).read();
    }
}
