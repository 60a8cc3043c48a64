package org.evoloop.journal;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** Random inputs that a core could receive, including failures. */
final class Story {
    private static final List<String> EVENTS = List.of("Clean", "Spot", "arriveSpot", "nobody's");

    private final Random random;
    private final Rules rules;
    private final Core core;
    private long now;

    private Story(Rules rules, Random random) {
        this.rules = rules;
        this.random = random;
        this.core = new Core(rules, output -> {});
    }

    /** This many inputs, each a nanosecond or more after the previous one. */
    static List<Input> of(Rules rules, Random random, int length) {
        Story story = new Story(rules, random);
        List<Input> inputs = new ArrayList<>();
        while (inputs.size() < length) {
            Input next = story.next();
            story.core.apply(next);
            inputs.add(next);
        }
        return inputs;
    }

    private Input next() {
        now += 1 + random.nextInt(1_000_000_000);
        Snapshot at = core.snapshot();
        Work work = at.work();
        if (!at.open()) {
            return new Input.Opened(now);
        }
        switch (random.nextInt(8)) {
            case 0, 1:
                return new Input.Observed(occurrence(at));
            case 2:
                return seldom(at, work);
            default:
                return work == null ? new Input.Ready() : proceed(at, work);
        }
    }

    private Occurrence occurrence(Snapshot at) {
        String event = EVENTS.get(random.nextInt(EVENTS.size()));
        Values values = random.nextBoolean()
                ? Values.NONE
                : Values.of("room", "küche").with("area", 2.5).with("dry", true);
        return switch (random.nextInt(5)) {
            case 0 -> new Occurrence.Heard(new Event(event), values, Source.PANEL, true, Set.of("wet"), 0, now);
            case 1 ->
                new Occurrence.Asked(new Event("Clean"), values, at.visit().number(), now);
            case 2 -> new Occurrence.Found(new State(random.nextBoolean() ? "On" : "Clean"), now);
            case 3 -> new Occurrence.Heard(new Event("endSpot"), Values.NONE, Source.DEVICE, 0, now);
            default -> new Occurrence.Heard(new Event(event), values, Source.CONTROLLER, 0, now);
        };
    }

    private Input seldom(Snapshot at, Work work) {
        long number = work == null ? 0 : work.pending().number();
        return switch (random.nextInt(9)) {
            case 0 -> new Input.Failed(number, "it failed", now);
            case 1 -> new Input.GivenUp(number, "it hangs", now);
            case 2 -> new Input.Dismissed(number, now);
            case 3 -> new Input.Recovered(now);
            case 4 -> new Input.Closing();
            case 5 -> new Input.Closed();
            case 6 -> new Input.Changed(rules, now);
            default -> new Input.TimerDue(at.visit().number(), new Event("timeout"), now);
        };
    }

    private Input proceed(Snapshot at, Work work) {
        long number = work.pending().number();
        Decision decision = work.decision();
        if (work.stage() == Work.Stage.INTERRUPTED) {
            return new Input.Ready();
        } else if (decision == null) {
            return random.nextInt(9) == 0
                    ? new Input.Planned(number, new Decision.Refused(at.at(), "a child lock"), now)
                    : new Input.Planned(number, rules.decide(at.at(), at.steps(), work.pending(), guard -> false), now);
        } else if (work.stage() == Work.Stage.RESUMED) {
            return new Input.Planned(number, decision, now);
        } else if (decision instanceof Decision.Inquiry) {
            return new Input.Located(number, random.nextBoolean() ? new State("On") : null, now);
        } else if (work.taken() < decision.steps().size()) {
            return work.sending() ? new Input.Sent(number, random.nextBoolean(), now) : new Input.Sending(number);
        }
        return work.stage() == Work.Stage.RUNNING
                ? new Input.EffectRun(number, random.nextBoolean() ? "" : "it broke", now)
                : new Input.Running(number);
    }
}
