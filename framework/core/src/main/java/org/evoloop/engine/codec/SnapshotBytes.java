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
    public static final int VERSION = 2;

    private SnapshotBytes() {}

    /** The bytes of {@code snapshot}; the first is the version. */
    public static byte[] write(Snapshot snapshot) {
        ByteWriter writer = new ByteWriter();
        write(writer, snapshot);
        return writer.written();
    }

    /** Writes {@code snapshot} after what {@code writer} has written. */
    public static void write(ByteWriter writer, Snapshot snapshot) {
        writer.number(VERSION);
        new SnapshotWriter(writer).write(snapshot);
    }

    /** The snapshot with these bytes; otherwise as the other method. */
    public static Snapshot read(Rules rules, byte[] bytes) {
        return read(rules, new ByteItems("snapshot", bytes, 0));
    }

    /**
     * Reads a snapshot.
     *
     * @param rules the rules, with the models to which the named states and transitions belong
     * @param items what follows; it ends where they end
     * @throws CodecException if it is not such a snapshot, is of another version, or names something that the models
     *     do not have
     */
    public static Snapshot read(Rules rules, ByteItems items) {
        items.requireVersion(items.number(), VERSION);
        return new SnapshotReader(rules.table().models(), items).read();
    }
}
