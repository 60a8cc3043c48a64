package org.evoloop.models.evolution;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Carried;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Migration;
import org.evoloop.models.format.Json;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** A swap's plan as JSON, in the shape that docs/models.md promises: components are the keys, in this order. */
public record MigrationJson(Models from, Models to, boolean possible, List<Row> pairs) {

    /** The names of two models. */
    public record Models(
            String original, @JsonProperty("new") String evolved) {}

    /** A pair of states and the result of the swap in it. Values that do not apply are null. */
    public record Row(
            String originalState,
            String newState,
            String kind,
            @Nullable String toOriginalState,
            @Nullable String toNewState,
            List<String> events,
            List<Part> carried,
            List<String> exits,
            List<String> uncertain,
            @Nullable String reason) {}

    /** A timer or a function, and what the swap does with it. */
    public record Part(String part, String name, String becomes, String how) {}

    public static String write(ModelPair before, ModelPair after, Migration migration) {
        return Json.write(new MigrationJson(
                models(before),
                models(after),
                migration.isPossible(),
                migration.lines().stream().map(MigrationJson::row).toList()));
    }

    private static Models models(ModelPair pair) {
        return new Models(pair.original().name(), pair.evolved().name());
    }

    private static Row row(Migration.Line line) {
        String device = line.at().original().name();
        String system = line.at().evolved().name();
        String kind = FateKind.of(line.fate()).key();
        if (line.fate() instanceof Fate.Maps maps) {
            return new Row(
                    device,
                    system,
                    kind,
                    maps.to().original().name(),
                    maps.to().evolved().name(),
                    maps.steps().stream().map(step -> step.trigger().name()).toList(),
                    maps.carried().stream().map(MigrationJson::part).toList(),
                    List.of(),
                    List.of(),
                    null);
        } else if (line.fate() instanceof Fate.Waits waits) {
            return new Row(
                    device,
                    system,
                    kind,
                    null,
                    null,
                    List.of(),
                    List.of(),
                    names(waits.exits()),
                    names(waits.uncertain()),
                    waits.because());
        }
        String reason = ((Fate.Stuck) line.fate()).because();
        return new Row(device, system, kind, null, null, List.of(), List.of(), List.of(), List.of(), reason);
    }

    private static Part part(Carried carried) {
        return new Part(Json.word(carried.part()), carried.name(), carried.becomes(), Json.word(carried.how()));
    }

    private static List<String> names(List<Event> events) {
        return events.stream().map(Event::toString).toList();
    }
}
