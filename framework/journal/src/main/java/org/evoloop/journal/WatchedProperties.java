package org.evoloop.journal;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.temporal.PropertyWatch;
import org.evoloop.check.temporal.PropertyWatch.Standing;
import org.evoloop.engine.Output;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.journal.DryRun.Broken;
import org.evoloop.rehearsal.Ending;
import org.jspecify.annotations.Nullable;

/** The properties that are watched while other models process a journal's events. */
final class WatchedProperties {
    private final List<Property> properties;
    private final List<Broken> broken = new ArrayList<>();
    private @Nullable PropertyWatch watch;
    private @Nullable Head head;

    WatchedProperties(List<Property> properties) {
        this.properties = properties;
    }

    /** Another process begins, on its own clock and with its own components. */
    void begin(DecisionTable table, Configuration at, Head process) {
        head = process;
        if (watch != null) {
            watch.decideBy(table);
            return;
        }
        PropertyWatch begun = new PropertyWatch(properties, table, at);
        watch = begun;
        add(begun.broken(), process.nowNanos(), process, null, at);
    }

    /** An event has ended. */
    void see(Ending ending) {
        PropertyWatch watching = watch;
        Head process = head;
        if (watching != null && process != null) {
            Output.Ended ended = ending.ended();
            Occurrence occurrence = ended.occurrence();
            add(
                    watching.ended(occurrence, ended.after(), ended.outcome(), ended.decision()),
                    occurrence.observedNanos(),
                    process,
                    occurrence,
                    ended.after());
        }
    }

    private void add(
            List<Property> now, long nanos, Head process, @Nullable Occurrence occurrence, Configuration where) {
        now.forEach(property -> broken.add(new Broken(property, process.wallTime(nanos), occurrence, where)));
    }

    List<Broken> broken() {
        return List.copyOf(broken);
    }

    /** The properties that require something that has not come. */
    List<Property> open() {
        PropertyWatch watching = watch;
        return watching == null
                ? List.of()
                : properties.stream()
                        .filter(property -> watching.standing(property) == Standing.OPEN)
                        .toList();
    }
}
