package org.evoloop.check.timing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import org.evoloop.check.CheckInput;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Moment;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * A {@link RandomTiming} as a Markov decision process with digital clocks in PRISM's language, generated from the
 * decisions without using any of the code that it checks. A place is a configuration, or a configuration in which a
 * step of a decision is being sent.
 */
final class PrismText {
    private static final int NONE = -1;
    private static final int CAP = 30;

    private final RandomTiming timing;
    private final DecisionTable table;
    private final TimeForm form;
    private final long unit;
    private final Map<Place, Integer> places = new LinkedHashMap<>();
    private final Queue<Place> frontier = new ArrayDeque<>();
    private final List<String> commands = new ArrayList<>();
    private final List<String> blocked = new ArrayList<>();

    /** @param decision whose step number {@code step} is being sent; null if none is */
    private record Place(Configuration at, @Nullable Decision decision, int step) {}

    private PrismText(RandomTiming timing) {
        this.timing = timing;
        this.table = DecisionTable.compile(
                timing.pair(), CheckInput.of(timing.pair()).device());
        this.form = timing.file().time().properties().get(0).form();
        this.unit = 500_000_000;
    }

    /** The model, with the label {@code bad} where the property is violated. */
    static String of(RandomTiming timing) {
        return new PrismText(timing).write();
    }

    private String write() {
        Place first = new Place(timing.pair().initial(), null, 0);
        place(first);
        Watching start = new Watching(0);
        start.see(code(first.at(), null));
        for (Place place = frontier.poll(); place != null; place = frontier.poll()) {
            leave(place);
        }
        int gap = gap();
        return """
                mdp
                module converter
                  loc : [0..%d] init 0;
                  t : [-1..%d] init -1;
                  s : [0..%d] init 0;
                  g : [0..%d] init %d;
                  x : [-1..%d] init %d;
                  bad : bool init %s;
                %s  [] !bad & !(%s) -> (t'=(t>0 ? t-1 : t)) & (s'=min(s+1,%d)) & (g'=min(g+1,%d)) \
                & (x'=(x>=0 ? min(x+1,%d) : x)) & (bad'=%s);
                  [] bad -> true;
                endmodule
                label "bad" = bad;
                """.formatted(
                        places.size(),
                        CAP,
                        CAP,
                        gap,
                        gap,
                        CAP,
                        start.first(),
                        start.isBad,
                        String.join("", commands),
                        blocked.isEmpty() ? "false" : String.join(" | ", blocked),
                        CAP,
                        gap,
                        CAP,
                        bound() < 0 ? "false" : "x>=0 & x+1>" + bound());
    }

    private int gap() {
        return (int)
                (timing.file().time().assumptions(Assumption.Gap.class).get(0).minNanos() / unit);
    }

    /** How many ticks may pass; -1 if passing time violates nothing. */
    private long bound() {
        if (form instanceof TimeForm.Response response) {
            return response.span().maxNanos() / unit;
        }
        boolean longest = form instanceof TimeForm.Stay stay && stay.span().maxNanos() != Span.FOR_EVER;
        return longest ? ((TimeForm.Stay) form).span().maxNanos() / unit : -1;
    }

    private int place(Place place) {
        Integer known = places.get(place);
        if (known == null) {
            known = places.size();
            places.put(place, known);
            frontier.add(place);
        }
        return known;
    }

    private int code(Configuration at, @Nullable Event event) {
        Moment moment = new Moment(at, event);
        Formula other = form.other();
        return (form.subject().isSeenIn(moment, timing.pair()) ? 1 : 0)
                | (other.isSeenIn(moment, timing.pair()) ? 2 : 0);
    }

    private void leave(Place place) {
        int number = places.get(place);
        for (Event event : timing.pair().evolved().triggers()) {
            if (event.timeTrigger().isEmpty()) {
                press(place, number, event);
            }
        }
        if (place.decision() == null) {
            timing.pair().evolved().timers(place.at().evolved()).forEach((event, delay) -> {
                Way way = new Way(place.at(), "loc=" + number + " & t=0", NONE);
                way.event(event);
                way.decide(event);
                blocked.add("(loc=" + number + " & t=0)");
            });
        } else {
            Span span = span(place.decision().steps().get(place.step()));
            Way way = new Way(place.at(), "loc=" + number + " & s>=" + span.minNanos() / unit, NONE);
            way.land(place.decision(), place.step());
            blocked.add("(loc=" + number + " & s>=" + span.maxNanos() / unit + ")");
        }
    }

    private void press(Place place, int number, Event event) {
        Way way = new Way(place.at(), "loc=" + number + " & g>=" + gap(), 0);
        way.event(event);
        if (place.decision() == null) {
            way.decide(event);
        } else {
            // The event is lost, since there is no queue.
            way.arrive(place, "t");
        }
    }

    private Span span(Step step) {
        return timing.file()
                .time()
                .find(
                        Assumption.Takes.class,
                        takes -> takes.event().equals(step.trigger().name()))
                .map(Assumption.Takes::span)
                .orElse(new Span(0, 0));
    }

    /** The observations of the subject along one command, starting with the present {@code x}. */
    private final class Watching {
        static final int KEPT = -2;

        int age = KEPT;
        boolean isBad;
        String badIf = "";

        private int seen;

        Watching(int seen) {
            this.seen = seen;
        }

        void see(int code) {
            boolean begins = (code & 1) != 0 && (seen & 1) == 0;
            boolean ends = (code & 1) == 0 && (seen & 1) != 0;
            seen = code;
            if (form instanceof TimeForm.Response) {
                if ((code & 2) != 0) {
                    age = NONE;
                } else if (begins && age == KEPT) {
                    // The oldest one counts.
                    badIf = "keep";
                    age = KEPT - 1;
                } else if (begins && age == NONE) {
                    age = 0;
                }
            } else if (form instanceof TimeForm.Stay stay) {
                if (ends && stay.span().maxNanos() == Span.FOR_EVER) {
                    long min = stay.span().minNanos() / unit;
                    badIf = age == KEPT ? "x>=0 & x<" + min : badIf;
                    isBad |= age >= 0 && age < min;
                }
                age = begins ? 0 : ends ? NONE : age;
            } else if (begins) {
                TimeForm.Count count = (TimeForm.Count) form;
                badIf = age == KEPT ? "x>=0 & x<=" + count.windowNanos() / unit : badIf;
                isBad |= age >= 0;
                age = 0;
            }
        }

        /** The initial value. */
        int first() {
            return age == KEPT ? NONE : age == KEPT - 1 ? 0 : age;
        }

        String update() {
            String bad = isBad ? "true" : badIf.isEmpty() || "keep".equals(badIf) ? "bad" : badIf;
            String next = age == KEPT ? "x" : age == KEPT - 1 ? "(x<0 ? 0 : x)" : String.valueOf(age);
            return "(x'=" + next + ") & (bad'=" + bad + ")";
        }
    }

    /** One command, from its guard to its target. */
    private final class Way {
        private final String guard;
        private final int gapAfter;
        private final Watching watching;
        private Configuration at;

        Way(Configuration at, String guard, int gapAfter) {
            this.at = at;
            this.guard = guard;
            this.gapAfter = gapAfter;
            this.watching = new Watching(code(at, null));
        }

        void event(Event event) {
            watching.see(code(at, event));
            watching.see(code(at, null));
        }

        void move(Configuration to) {
            if (!to.equals(at)) {
                at = to;
                watching.see(code(at, null));
            }
        }

        void decide(Event event) {
            Decision decision = table.decide(at, event, false);
            if (decision.transition() == null) {
                boolean timer = event.timeTrigger().isPresent();
                arrive(new Place(at, null, 0), timer ? "-1" : "t");
            } else {
                go(decision, 0);
            }
        }

        void land(Decision decision, int step) {
            move(at.withOriginal(decision.steps().get(step).target()));
            go(decision, step + 1);
        }

        private void go(Decision decision, int step) {
            if (step < decision.steps().size()) {
                if (span(decision.steps().get(step)).maxNanos() == 0) {
                    land(decision, step);
                } else {
                    arrive(new Place(at, decision, step), "-1");
                }
                return;
            }
            move(decision.after());
            long timer = timing.pair().evolved().timers(at.evolved()).values().stream()
                    .mapToLong(delay -> delay.toNanos() / unit)
                    .findFirst()
                    .orElse(NONE);
            arrive(new Place(at, null, 0), String.valueOf(timer));
        }

        void arrive(Place target, String timer) {
            boolean lost = target.decision() != null && "t".equals(timer);
            commands.add("  [] !bad & " + guard + " -> (loc'=" + place(target) + ") & (t'=" + timer + ") & (s'="
                    + (lost ? "s" : "0") + ") & (g'=" + (gapAfter == NONE ? "g" : "0") + ") & " + watching.update()
                    + ";\n");
        }
    }
}
