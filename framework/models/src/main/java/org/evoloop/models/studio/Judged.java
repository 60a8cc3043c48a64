package org.evoloop.models.studio;

import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.timing.TimeCheck;
import org.evoloop.check.timing.TimeReport;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.temporal.PropertyCheck;
import org.evoloop.payload.JsonObject;
import org.evoloop.studio.Pair;
import org.evoloop.studio.RequestException;

/** Whether a property holds, with what shows that it does not. */
final class Judged {
    private Judged() {}

    static JsonObject property(Pair pair, String text) {
        ModelPair models = pair.flat();
        models.requireValid();
        // A name is not needed here.
        String named = text.matches("(?s)[^\"]+?:\\s.*") ? text : "the property: " + text;
        PropertyFile file = PropertyFile.parse("property", named, models);
        if (file.properties().isEmpty() && file.time().properties().isEmpty()) {
            throw new RequestException("this is no property; write one, such as: the lamp goes off: always can off");
        }
        CheckInput input = CheckInput.of(models).withDevice(DeviceEvents.assumedOf(models.original()));
        TimeReport times = TimeCheck.run(input, file.time(), file.file());
        List<Finding> timed = times.findings().stream()
                .filter(finding -> finding.rule() == Rule.PROPERTY)
                .toList();
        List<Finding> found = file.time().properties().isEmpty() ? PropertyCheck.run(input, file) : timed;
        boolean decided =
                times.undecided().isEmpty() && found.stream().noneMatch(each -> each.rule() == Rule.UNKNOWN_PROPERTY);
        JsonObject answer =
                new JsonObject().put("holds", decided && found.isEmpty()).put("decided", decided);
        if (found.isEmpty()) {
            String verdicts = times.verdicts().stream().map(Object::toString).collect(Collectors.joining("; "));
            String words = decided ? "it holds in every run" : String.join("; ", times.undecided());
            return answer.put("words", verdicts.isEmpty() ? words : verdicts).put("run", List.<JsonObject>of());
        }
        Finding first = found.get(0);
        String broken = file.properties().isEmpty() ? first.message() : "it does not hold; the run shows it";
        return answer.put("words", decided ? broken : first.message())
                .put("run", Played.of(first.example(), DecisionTable.compile(models, input.device())))
                .put("timed", first.timed().stream().map(Judged::timed).toList());
    }

    private static JsonObject timed(TimedEvent event) {
        return new JsonObject()
                .put("millis", event.atNanos() / 1_000_000)
                .put("what", event.what())
                .put("original", event.after().original().name())
                .put("new", event.after().evolved().name())
                .put("sending", event.step());
    }
}
