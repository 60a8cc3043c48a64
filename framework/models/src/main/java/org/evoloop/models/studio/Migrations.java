package org.evoloop.models.studio;

import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping;
import org.evoloop.migration.Migration;
import org.evoloop.models.evolution.MigrationJson;
import org.evoloop.models.evolution.MigrationText;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.studio.Pair;

/** What becomes of each pair of states if other models replace the running ones. */
final class Migrations {
    private Migrations() {}

    static JsonObject table(Pair running, Pair next) {
        ModelPair before = running.flat();
        ModelPair after = next.flat();
        before.requireValid();
        after.requireValid();
        Migration migration = Migration.plan(
                DecisionTable.compile(before, DeviceEvents.assumedOf(before.original())),
                DecisionTable.compile(after, DeviceEvents.assumedOf(after.original())),
                Mapping.byName());
        return new JsonObject()
                .put("words", MigrationText.write(before, after, migration))
                .put("possible", migration.isPossible())
                .put(
                        "table",
                        JsonRecord.of(MigrationJson.write(before, after, migration))
                                .copy());
    }
}
