package org.evoloop.models.record;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Statement;
import org.evoloop.evolution.Occurrence;
import org.evoloop.journal.JournalFiles.SegmentInfo;
import org.evoloop.journal.JournalRecord;
import org.evoloop.models.format.Json;
import org.jspecify.annotations.Nullable;

/**
 * Journal records in an SQLite database.
 *
 * <p>Threading: not thread-safe.
 */
public final class RecordTable implements AutoCloseable {
    private static final int BATCH = 1_000;

    private final Connection database;
    private final PreparedStatement record;
    private final PreparedStatement segment;
    private int waiting;

    /** @param file the database, which must not exist yet @throws SQLException if it cannot be created */
    public RecordTable(String file) throws SQLException {
        database = DriverManager.getConnection("jdbc:sqlite:" + file);
        database.setAutoCommit(false);
        try (Statement create = database.createStatement()) {
            create.execute(
                    "CREATE TABLE segment (segment TEXT PRIMARY KEY, fingerprint TEXT NOT NULL, original TEXT NOT NULL,"
                            + " new TEXT NOT NULL, begun TEXT NOT NULL, records INTEGER NOT NULL, cut_off INTEGER NOT NULL)");
            create.execute("CREATE TABLE record (segment TEXT NOT NULL, record INTEGER NOT NULL, byte INTEGER NOT NULL,"
                    + " time TEXT NOT NULL, nanos INTEGER NOT NULL, kind TEXT NOT NULL, event TEXT, source TEXT,"
                    + " event_values TEXT, text TEXT NOT NULL, original TEXT NOT NULL, new TEXT NOT NULL,"
                    + " doubt TEXT NOT NULL, endings TEXT NOT NULL, PRIMARY KEY (segment, record))");
        }
        record = database.prepareStatement("INSERT INTO record VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
        segment = database.prepareStatement("INSERT INTO segment VALUES (?,?,?,?,?,?,?)");
    }

    /** Adds a record. */
    public void add(JournalRecord written) throws SQLException {
        Occurrence occurrence = RecordJson.occurrence(written);
        fill(
                record,
                written.segment(),
                written.number(),
                written.offset(),
                written.at().toString(),
                written.nanos(),
                written.kind(),
                occurrence == null ? null : occurrence.label(),
                occurrence == null ? null : Json.word(occurrence.source()),
                occurrence == null || occurrence.values().isEmpty() ? null : RecordJson.values(occurrence),
                InputText.of(written.input()),
                written.where().original().name(),
                written.where().evolved().name(),
                written.doubt(),
                String.join("; ", written.endings()));
        waiting++;
        if (waiting == BATCH) {
            flush();
        }
    }

    /** Adds a segment. */
    public void add(SegmentInfo info) throws SQLException {
        fill(
                segment,
                info.segment(),
                info.fingerprint(),
                info.original(),
                info.evolved(),
                info.begun().toString(),
                info.records(),
                info.cutOff());
    }

    private static void fill(PreparedStatement row, @Nullable Object... values) throws SQLException {
        for (int index = 0; index < values.length; index++) {
            row.setObject(index + 1, values[index]);
        }
        row.addBatch();
    }

    private void flush() throws SQLException {
        record.executeBatch();
        waiting = 0;
    }

    /** Commits everything added. */
    public void commit() throws SQLException {
        flush();
        segment.executeBatch();
        database.commit();
    }

    @Override
    public void close() throws SQLException {
        database.close();
    }
}
