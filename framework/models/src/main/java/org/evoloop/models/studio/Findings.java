package org.evoloop.models.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawings;
import org.evoloop.models.checking.SamePlace;
import org.evoloop.models.temporal.PairCheck;
import org.evoloop.payload.JsonObject;
import org.evoloop.statechart.Place;
import org.evoloop.statemachine.ModelException;
import org.evoloop.studio.Analysis.Written;
import org.evoloop.studio.Mistake;
import org.evoloop.studio.MistakeException;
import org.evoloop.studio.Pair;
import org.evoloop.studio.Source;
import org.jspecify.annotations.Nullable;

/** The findings of a pair of models, each with its line. */
final class Findings {
    /** The flat models of more transitions take too long while one types. */
    private static final int MOST_TRANSITIONS = 5_000;

    private final List<JsonObject> found = new ArrayList<>();

    private Findings() {}

    static JsonObject check(Pair pair, Written properties) {
        return new Findings().of(pair, properties);
    }

    private JsonObject of(Pair pair, Written properties) {
        Shown original = read(pair.original());
        Shown evolved = read(pair.evolved());
        JsonObject answer = new JsonObject();
        if (original != null && evolved != null) {
            ModelPair models = new ModelPair(original.require(), evolved.require());
            int transitions = models.original().transitions().size()
                    + models.evolved().transitions().size();
            if (transitions > MOST_TRANSITIONS) {
                answer.put(
                        "tooLarge",
                        "together the models have " + transitions + " transitions when they are flat, too many to be"
                                + " checked here; use ./evoloop models check");
            } else {
                found(models, original, evolved, properties, answer);
            }
        }
        return answer.put("findings", found);
    }

    private @Nullable Shown read(Source source) {
        try {
            Shown shown = Shown.of(source);
            shown.require();
            return shown;
        } catch (MistakeException mistaken) {
            mistaken.all().forEach(mistake -> add(mistake, "mistake"));
            return null;
        }
    }

    private void add(Mistake mistake, String rule) {
        found.add(mistake.json().put("severity", "error").put("rule", rule).put("why", ""));
    }

    private void found(ModelPair models, Shown original, Shown evolved, Written properties, JsonObject answer) {
        CheckInput input = CheckInput.of(models).withDevice(DeviceEvents.assumedOf(models.original()));
        PairCheck check;
        try {
            check = PairCheck.run(input, () -> PropertyFile.parse(properties.path(), properties.text(), models));
        } catch (ModelException unreadable) {
            Mistake.all(properties.path(), unreadable).forEach(mistake -> add(mistake, "mistake"));
            check = run(input);
        }
        Drawings drawings = new Drawings(original.drawing(), evolved.drawing());
        DecisionTable table = null;
        for (Finding finding : SamePlace.merge(check.written().switches().left(check.findings()), drawings)) {
            boolean isOriginal = finding.element().side() == Element.ModelRole.ORIGINAL;
            JsonObject each = json(finding, isOriginal ? original : evolved);
            if (!finding.example().isEmpty()) {
                table = table == null ? DecisionTable.compile(models, input.device()) : table;
                each.put("run", Played.of(finding.example(), table));
            }
            found.add(each);
        }
        check.times().undecided().forEach(undecided -> add(new Mistake(properties.path(), 1, 1, undecided), "time"));
        answer.putTexts(
                "times", check.times().verdicts().stream().map(Object::toString).toList());
    }

    private static PairCheck run(CheckInput input) {
        return PairCheck.run(input, PropertyFile::none);
    }

    private static JsonObject json(Finding finding, Shown shown) {
        Place place = shown.drawing().find(finding.element()).orElse(Place.NONE);
        JsonObject json = new JsonObject()
                .put("severity", finding.rule().severity().name().toLowerCase(Locale.ROOT))
                .put("rule", finding.rule().id())
                .put("message", finding.message())
                .put("why", finding.remedy())
                .put("machine", finding.element().side().name().toLowerCase(Locale.ROOT))
                .put("path", shown.source().path())
                .put(
                        "line",
                        Math.max(
                                1,
                                place.line() > 0
                                        ? place.line()
                                        : shown.source().machine().line()));
        if (finding.element() instanceof Element.OfState of) {
            shown.drawing()
                    .state(of.state())
                    .ifPresent(vertex -> json.put("state", shown.index().name(vertex.key())));
        } else if (finding.element() instanceof Element.OfTransition of) {
            shown.drawing().transition(of.transition()).ifPresent(arc -> json.put("transition", shown.id(arc)));
        }
        return json;
    }
}
