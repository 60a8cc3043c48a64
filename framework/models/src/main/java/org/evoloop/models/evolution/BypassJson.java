package org.evoloop.models.evolution;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.models.evolution.Bypass.Line;
import org.evoloop.models.format.Json;
import org.evoloop.statemachine.Event;

/** A bypass as JSON, in the shape that docs/models.md promises: components are the keys, in this order. */
public record BypassJson(
        String original, @JsonProperty("new") String evolved, List<Row> bypass, List<Stopped> stopped) {

    /** One event in one pair of states. */
    public record Row(
            String originalState,
            String newState,
            String event,
            String kind,
            String deviceState,
            Converted converter,
            Where found) {}

    /** What the converter would do: the events it would send and the states after them. */
    public record Converted(boolean possible, List<String> events, String originalState, String newState) {}

    /** The states of both models. */
    public record Where(String originalState, String newState) {}

    /** What would not run: the function of a new state, and the timers of a state. */
    public record Stopped(String originalState, String newState, boolean function, List<String> timers) {}

    public static String write(Bypass bypass) {
        return Json.write(new BypassJson(
                bypass.pair().original().name(),
                bypass.pair().evolved().name(),
                bypass.lines().stream().map(BypassJson::row).toList(),
                bypass.stopped().stream().map(at -> stopped(at, bypass)).toList()));
    }

    private static Row row(Line line) {
        Decision decision = line.decision();
        return new Row(
                line.at().original().name(),
                line.at().evolved().name(),
                line.event().toString(),
                Json.word(line.kind()),
                line.device().name(),
                new Converted(
                        !(decision instanceof Decision.Impossible),
                        decision.steps().stream()
                                .map(step -> step.trigger().name())
                                .toList(),
                        decision.after().original().name(),
                        decision.after().evolved().name()),
                new Where(line.found().original().name(), line.found().evolved().name()));
    }

    private static Stopped stopped(Configuration at, Bypass bypass) {
        return new Stopped(
                at.original().name(),
                at.evolved().name(),
                bypass.pair().isNew(at.evolved()),
                bypass.pair().evolved().timers(at.evolved()).keySet().stream()
                        .map(Event::toString)
                        .toList());
    }
}
