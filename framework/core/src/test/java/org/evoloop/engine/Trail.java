package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * A story of the specification in {@code prism/proof}, as {@code ./evoloop study --proof} writes it: inputs in words,
 * each followed by a line that begins with {@code =} and states what the core then knows.
 */
final class Trail {
    private final Scene scene;
    private final Wiring wiring;
    private final List<Decision> plans = new ArrayList<>();
    private Snapshot now;
    private boolean swapped;
    private long time = 1;

    private Trail(Scene scene, Wiring wiring) {
        this.scene = scene;
        this.wiring = wiring;
        this.now = new Core(scene.rules(), output -> {}).snapshot();
    }

    /** Gives the core all inputs; empty if it agrees with the story to its end, else where it first differs. */
    static String follow(Scene scene, Wiring wiring, List<String> lines) {
        Trail trail = new Trail(scene, wiring);
        for (int index = 0; index < lines.size(); index++) {
            String line = lines.get(index);
            if (!line.startsWith("=")) {
                trail.apply(line.split(" "));
            } else if (!line.equals(trail.state())) {
                return "after " + lines.get(index - 1) + ": " + trail.state() + " instead of " + line;
            }
        }
        return "";
    }

    private Rules rules() {
        return swapped ? scene.next() : scene.rules();
    }

    private String state() {
        return state(now);
    }

    /** In words, the part of the state that the specification also has. */
    static String state(Snapshot now) {
        Work work = now.work();
        String doing = work == null
                ? "idle"
                : work.decision() == null ? "deciding" : work.stage().name();
        Doubt doubt = now.doubt();
        return String.join(
                " ",
                "=",
                now.open() ? "open" : "closed",
                now.at().original().name(),
                now.at().evolved().name(),
                doubt == null ? "sure" : certainty(doubt),
                "waiting",
                String.valueOf(now.waiting().size()),
                doing,
                now.visit().over() ? "over" : "visit",
                now.visit().deadlines().isEmpty() ? "-" : "timer",
                owed(now));
    }

    private static String certainty(Doubt doubt) {
        return doubt.interrupted() != null
                ? (doubt.settled() ? "reported" : "remembering")
                : (doubt.settled() ? "settled" : "doubt");
    }

    private static String owed(Snapshot now) {
        if (now.visit().startOwed()) {
            return now.followOwed() ? "owed-start" : "start";
        }
        return now.followOwed() ? "owed" : "-";
    }

    private void apply(String[] words) {
        Input input = input(words);
        Rules counted = rules();
        if (input instanceof Input.Evolved
                && new Core(counted, now, output -> {})
                        .hindrance(scene.swap(swapped))
                        .isEmpty()) {
            swapped = !swapped;
        }
        boolean wasIdle = now.work() == null;
        now = wiring.apply(counted, now, input).after();
        time++;
        Work work = now.work();
        if (work == null || work.decision() != null || wasIdle) {
            plans.clear();
        }
        if (work != null && work.decision() == null) {
            plans.add(rules().decide(now.at(), now.steps(), work.pending(), guard -> false));
        }
    }

    private Input input(String[] words) {
        long number = now.work() == null ? 0 : now.work().pending().number();
        return switch (words[0]) {
            case "opened" -> new Input.Opened(time);
            case "closing" -> new Input.Closing();
            case "closed" -> new Input.Closed();
            case "recovered" -> new Input.Recovered(time);
            case "changed" -> new Input.Changed(rules(), time);
            case "evolved" -> new Input.Evolved(scene.swap(swapped), time);
            case "ready" -> new Input.Ready();
            case "press" -> heard(words[1], Source.CONTROLLER, false, Occurrence.ANY_VISIT);
            case "own" -> heard(words[1], Source.DEVICE, words[2].equals("acted"), Occurrence.ANY_VISIT);
            case "raise" -> heard(words[1], Source.FUNCTION, false, visit(words[2]));
            case "ask" ->
                new Input.Observed(new Occurrence.Asked(new Event(words[1]), Values.NONE, visit(words[2]), time));
            case "found" ->
                new Input.Observed(new Occurrence.Found(
                        new State(words[1]), words[2].equals("late") ? now.lastStepNanos() - 1 : time));
            case "timer" -> timer();
            case "planned" -> new Input.Planned(number, plan(words[1], words[2]), time);
            case "sending" -> new Input.Sending(number);
            case "sent" -> new Input.Sent(Long.parseLong(words[1]), words[2].equals("in-order"), time);
            case "located" -> new Input.Located(number, words[1].equals("-") ? null : new State(words[1]), time);
            case "failed" -> new Input.Failed(number, "it failed", time);
            case "given-up" -> new Input.GivenUp(number, "it was given up", time);
            default -> throw new IllegalArgumentException("no input is called " + words[0]);
        };
    }

    private Input heard(String event, Source source, boolean acted, long visit) {
        return new Input.Observed(
                new Occurrence.Heard(new Event(event), Values.NONE, source, acted, Set.of(), visit, time));
    }

    private long visit(String which) {
        return now.visit().number() - (which.equals("former") ? 1 : 0);
    }

    private Input timer() {
        Event event = now.visit().deadlines().keySet().iterator().next();
        long due = now.visit().deadlines().getOrDefault(event, time);
        return new Input.TimerDue(now.visit().number(), event, due);
    }

    /** A decision that analyze may have made since the occurrence began, in these states. */
    private Decision plan(String device, String system) {
        Work work = now.work();
        if (work != null && work.decision() != null) {
            return work.decision();
        }
        return plans.stream()
                .filter(plan -> plan.deviceStart().name().equals(device)
                        && plan.before().evolved().name().equals(system))
                .findFirst()
                .orElseThrow(
                        () -> new AssertionError("nothing was decided in " + device + ", " + system + ": " + plans));
    }
}
