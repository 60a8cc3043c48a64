package org.evoloop.models.scaffold;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.models.scaffold.Scenario.Happening;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Writes the test methods of a project, one for each transition of the new model. */
final class TestText {
    private final JavaNames names = new JavaNames();
    private final Map<Transition, Scenario> scenarios;
    private final boolean guarded;

    /** @param guarded whether either model has guards */
    TestText(Map<Transition, Scenario> scenarios, boolean guarded) {
        this.scenarios = scenarios;
        this.guarded = guarded;
        List.of("device", "assertStands").forEach(names::reserve);
    }

    String methods(StateMachine evolved) {
        return evolved.transitions().stream()
                .map(transition -> {
                    Scenario scenario = scenarios.get(transition);
                    return scenario == null ? missing(transition) : method(scenario);
                })
                .collect(Collectors.joining("\n"));
    }

    private static String missing(Transition transition) {
        return "    // " + JavaText.comment(transition.toString())
                + " cannot be taken in a test: no events lead there, or only with guards that exclude each other.\n";
    }

    private String method(Scenario scenario) {
        Transition transition = scenario.transition();
        StringBuilder text = new StringBuilder("    @Test\n");
        text.append("    @DisplayName(")
                .append(JavaText.literal(transition.toString()))
                .append(")\n");
        text.append("    void ").append(name(transition)).append("() {\n");
        scenario.happenings().forEach(happening -> happening(text, happening));
        text.append("\n        assertStands(")
                .append(JavaText.literal(scenario.after().original().name()))
                .append(", ")
                .append(JavaText.literal(scenario.after().evolved().name()))
                .append(");\n    }\n");
        return text.toString();
    }

    private void happening(StringBuilder text, Happening happening) {
        if (guarded) {
            String guards =
                    happening.guards().stream().sorted().map(JavaText::literal).collect(Collectors.joining(", "));
            text.append("        conditions.only(Set.of(").append(guards).append("));\n");
        }
        Duration delay = happening.delay();
        if (delay != null) {
            text.append("        converter.advance(Duration.parse(\"")
                    .append(delay)
                    .append("\"));\n");
        } else {
            String how = happening.byDevice() ? "device" : "converter.press";
            text.append("        ")
                    .append(how)
                    .append('(')
                    .append(JavaText.literal(happening.event()))
                    .append(");\n");
        }
    }

    private String name(Transition transition) {
        String source = JavaNames.camel(transition.source().name(), "State");
        String event = JavaNames.camel(transition.event().name(), "Event");
        String target = JavaNames.camel(transition.target().name(), "State");
        return names.free(JavaNames.small(event) + "In" + source + "LeadsTo" + target);
    }
}
