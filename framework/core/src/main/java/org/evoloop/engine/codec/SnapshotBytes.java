package org.evoloop.engine.codec;

import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;

/**
 * Snapshots as bytes, for programs that store very many: shorter than {@link SnapshotText}. They contain the same items in
 * the same order, with the same names of states and transitions, and are refused for the same reasons. The same snapshot
 * gives the same bytes.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class SnapshotBytes {
    /** The version of the format. */
    public static final int VERSION = 1;

    /** Enough for most snapshots. */
    private static final int CAPACITY = 192;

    private SnapshotBytes() {}

    /** The bytes of {@code snapshot}; the first is the version. */
    public static byte[] write(Snapshot snapshot) {
        return write(new byte[CAPACITY], 0, snapshot);
    }

    /** The first {@code length} bytes of {@code head}, then those of {@code snapshot}. The rest of {@code head} is used, too. */
    public static byte[] write(byte[] head, int length, Snapshot snapshot) {
        ByteWriter writer = new ByteWriter(head, length);
        writer.number(VERSION);
        new SnapshotWriter(writer).write(snapshot);
        return writer.written();
    }

    /**
     * Reads a snapshot.
     *
     * @param rules the rules, with the models to which the named states and transitions belong
     * @param from where in {@code bytes} it begins; it ends where they end
     * @throws SnapshotException if it is not such a snapshot, is of another version, or names something that the models
     *     do not have
     */
    public static Snapshot read(Rules rules, byte[] bytes, int from) {
        ByteItems items = new ByteItems(bytes, from);
        long version = items.number();
        if (version != VERSION) {
            throw items.wrong("version " + version + " cannot be read, only version " + VERSION
                    + "; use the version of Evoloop that wrote it, or start without it");
        }
        return new SnapshotReader(rules.table().models(), items).read();
    }
}
