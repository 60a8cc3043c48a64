package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.FunctionSends;
import org.evoloop.check.Rule;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.temporal.Formula;
import org.evoloop.engine.Rules;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Timers;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;

/**
 * Decides the time properties of an evolution before it runs: over every reachable pair of states, with its timers, the
 * duration of steps, and its queue. The converter's own core computes what follows.
 *
 * <p>Threading: thread-safe, since it has no state.
 *
 * @since 0.1
 */
public final class TimeCheck {
    /** The largest number of moments explored for one property, which takes some ten seconds. */
    static final int MOST_MOMENTS = 2_000_000;

    private static final int MOST_TOGETHER = 4 * MOST_MOMENTS;

    /** The default queue capacity of a converter. */
    private static final int QUEUE = 8;

    /** If a bound does not hold, one that does is searched up to this many times as long. */
    private static final int FURTHER = 8;

    private final Rules rules;
    private final TimeRules written;
    private final FunctionSends sends;
    private final String file;
    private final Map<String, Span> takes = new TreeMap<>();
    private final List<TimeVerdict> verdicts = new ArrayList<>();
    private final List<Finding> findings = new ArrayList<>();
    private final List<String> undecided = new ArrayList<>();
    private int left = MOST_TOGETHER;

    private TimeCheck(CheckInput input, TimeRules written, String file) {
        this.written = written;
        this.sends = FunctionSends.possible(input);
        this.file = file;
        StateMachine evolved = input.pair().evolved();
        int queue = written.find(Assumption.Queue.class, any -> true)
                .map(Assumption.Queue::capacity)
                .orElse(QUEUE);
        this.rules = new Rules(DecisionTable.compile(input.pair(), input.device()), Timers.drawnIn(evolved), queue);
        written.assumptions(Assumption.Takes.class).forEach(each -> takes.put(each.event(), each.span()));
    }

    /**
     * All findings about time, and the verdict on each property.
     *
     * @param file for messages
     * @throws org.evoloop.statemachine.ModelException if the pair is not an evolution
     */
    public static TimeReport run(CheckInput input, TimeRules written, String file) {
        input.pair().requireValid();
        StateMachine evolved = input.pair().evolved();
        boolean isTimed = !written.equals(TimeRules.NONE)
                || evolved.states().stream()
                        .anyMatch(state -> !evolved.timers(state).isEmpty());
        if (!isTimed) {
            return TimeReport.NONE;
        }
        TimeReport report = new TimeCheck(input, written, file).run();
        return input.pair().hasUrgent()
                ? report.beside(new TimeCheck(input.withoutUrgent(), written, file).run())
                : report;
    }

    private TimeReport run() {
        String note = "";
        for (TimeProperty property : written.properties()) {
            try {
                judge(property);
            } catch (TooLargeException tooLarge) {
                undecided.add(file + ", line " + property.line() + ": '" + property.name() + "' cannot be decided: "
                        + tooLarge.getMessage() + "; " + remedy());
                // The others would be too large for the same reason, and each would take as long.
                return new TimeReport(verdicts, findings, undecided, "");
            }
        }
        try {
            Exploration exploration = exploration(List.of());
            TimeHazards hazards = new TimeHazards(exploration);
            exploration.run(hazards);
            findings.addAll(hazards.findings());
        } catch (TooLargeException tooLarge) {
            note = "whether timers race, steps outlive visits or time comes to a halt is not known: "
                    + tooLarge.getMessage() + "; " + remedy();
        }
        return new TimeReport(verdicts, findings, undecided, note);
    }

    private static String remedy() {
        return "write lengths of time with a greater common divisor, what is known about when events come, 'at least "
                + "... between presses', or a shorter 'queue'";
    }

    /** @param first judged; beside it those from whose violation something follows */
    private Exploration exploration(List<TimeForm> first) {
        List<TimeForm> forms = new ArrayList<>(first);
        List<Set<Event>> raised = new ArrayList<>();
        first.forEach(form -> raised.add(Set.of()));
        for (TimeProperty property : written.properties()) {
            Set<Event> events = new LinkedHashSet<>();
            for (Reaction reaction : written.reactions()) {
                if (reaction.property().equals(property.name())) {
                    events.add(reaction.event());
                }
            }
            if (!events.isEmpty()) {
                forms.add(property.form());
                raised.add(events);
            }
        }
        StateMachine original = rules.table().models().original();
        Ticks ticks = Ticks.of(written, original, rules.table().models().evolved(), rules.timers(), forms);
        Clocks clocks = new Clocks(rules, written, ticks, forms, takes);
        return new Exploration(rules, written, clocks, forms, raised, Math.min(MOST_MOMENTS, left));
    }

    private void judge(TimeProperty property) {
        Exploration exploration = exploration(List.of(property.form()));
        Measuring measuring = new Measuring(exploration, true);
        exploration.run(measuring);
        left -= exploration.visited.size();
        if (!sends.isEmpty() && isAboutDevice(property.form())) {
            findings.add(unknown(property, !measuring.isViolated()));
            return;
        }
        if (!measuring.isViolated()) {
            verdicts.add(measuring.verdict(property, exploration));
            return;
        }
        List<TimedEvent> way =
                Trace.of(exploration, measuring.from(), measuring.label(), "'" + property.name() + "' is violated");
        verdicts.add(further(property, measuring));
        findings.add(new Finding(
                Rule.PROPERTY,
                new Element.OfState(
                        Element.ModelRole.NEW, way.get(way.size() - 1).after().evolved()),
                named(property) + " does not hold",
                "change the new model or its times, write what is known about when events come, or change the property "
                        + "if it asks for too much",
                List.of(),
                way));
    }

    /** Where the device is depends on what functions send. */
    private static boolean isAboutDevice(TimeForm form) {
        return form.subject().names(Formula.Kind.DEVICE) || form.other().names(Formula.Kind.DEVICE);
    }

    private Finding unknown(TimeProperty property, boolean otherwise) {
        return new Finding(
                Rule.UNKNOWN_PROPERTY,
                new Element.OfState(
                        Element.ModelRole.NEW, sends.states().iterator().next()),
                named(property) + " is unknown, since " + sends.describe() + "; if nothing is sent, it "
                        + (otherwise ? "holds" : "does not hold"),
                FunctionSends.REMEDY,
                List.of());
    }

    private String named(TimeProperty property) {
        return "'" + property.name() + "' (" + file + ", line " + property.line() + ")";
    }

    /** The worst case, as far as it can be determined. */
    private TimeVerdict further(TimeProperty property, Measuring stopped) {
        try {
            TimeForm wider = wider(property.form());
            Exploration exploration = exploration(List.of(wider));
            Measuring measuring = new Measuring(exploration, false);
            exploration.run(measuring);
            left -= exploration.visited.size();
            TimeVerdict found = measuring.verdict(property, exploration);
            boolean bounded = !measuring.hasLapsed();
            return new TimeVerdict(
                    property, false, found.best(), bounded ? found.worst() : Span.FOR_EVER, found.moments());
        } catch (TooLargeException unknown) {
            return new TimeVerdict(property, false, stopped.best(), Span.FOR_EVER, MOST_MOMENTS);
        }
    }

    private static TimeForm wider(TimeForm form) {
        if (form instanceof TimeForm.Response response) {
            return new TimeForm.Response(
                    response.subject(),
                    response.other(),
                    new Span(
                            response.span().minNanos(),
                            FURTHER * response.span().maxNanos()));
        } else if (form instanceof TimeForm.Stay stay && stay.span().maxNanos() != Span.FOR_EVER) {
            return new TimeForm.Stay(
                    stay.subject(), new Span(0, FURTHER * stay.span().maxNanos()));
        }
        return form;
    }
}
