package org.evoloop.engine;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The surroundings of a core: the device's true state, what is being sent, and what the components were asked to do.
 */
final class World {
    /** Whether the converter accepts controllers' events. */
    enum Phase {
        CLOSED,
        OPEN,
        CLOSING
    }

    /** A step being sent to the device. */
    record Flight(long number, Step step) {}

    final Scene scene;
    State device;
    /** In the order in which it happened. */
    List<Token> unreported = new ArrayList<>();

    /** What is being sent; null if nothing is. */
    @Nullable
    Flight flight;
    /** Whether that has taken effect. */
    boolean landed;
    /** A step that was given up and may still take effect, but not after the device has reported its state. */
    @Nullable
    Flight stray;
    /** What the components have to do for the occurrence in progress. */
    Output.@Nullable Directive asked;
    /** The state that the device reported. */
    @Nullable
    State answer;
    /** What analyze may have decided since the occurrence began, on the states that it saw. */
    Set<Decision> plans = new LinkedHashSet<>();

    /**
     * Whether device and system were left in states that do not go together by an event that failed or was ignored,
     * that a function had the device do, or that came when they were in such states already; or by other models, which
     * take over such states as they are.
     */
    boolean mayBeApart;

    /** Whether the record may be wrong from now on, because a report was lost. */
    boolean misled;

    /** The last visit whose function was started, or continues in other models; 0 if there is none. */
    long functionOf;

    Phase phase = Phase.CLOSED;
    /** Whether the scene's next rules apply. */
    boolean evolved;

    Map<Scene.Act, Integer> left;

    World(Scene scene) {
        this.scene = scene;
        this.device = scene.rules().table().models().initial().original();
        this.left = new EnumMap<>(Scene.Act.class);
        left.putAll(scene.times());
    }

    private World(World same) {
        scene = same.scene;
        device = same.device;
        unreported = new ArrayList<>(same.unreported);
        flight = same.flight;
        landed = same.landed;
        stray = same.stray;
        asked = same.asked;
        answer = same.answer;
        plans = new LinkedHashSet<>(same.plans);
        mayBeApart = same.mayBeApart;
        misled = same.misled;
        functionOf = same.functionOf;
        phase = same.phase;
        evolved = same.evolved;
        left = new EnumMap<>(same.left);
    }

    World copy() {
        return new World(this);
    }

    /** The rules that apply now. */
    Rules rules() {
        return evolved ? scene.next() : scene.rules();
    }

    boolean may(Scene.Act act) {
        return left.getOrDefault(act, 0) > 0;
    }

    World spent(Scene.Act act) {
        World next = copy();
        next.left.merge(act, -1, Integer::sum);
        return next;
    }

    /** The state to which {@code trigger} takes the device while these guards hold. */
    State after(Event trigger, Set<String> holding) {
        Step step = rules().table().ownStep(device, trigger, holding::contains);
        return step == null ? device : step.target();
    }

    /** The states to which a step may take the device: guards were evaluated before only in the step's source. */
    Set<State> after(Step step) {
        Set<State> possible = new LinkedHashSet<>();
        if (device.equals(step.source())) {
            possible.add(step.target());
        } else {
            Answers.of(rules().table().models(), step.trigger())
                    .forEach(holding -> possible.add(after(step.trigger(), holding)));
        }
        return possible;
    }

    void noLongerSent() {
        flight = null;
        landed = false;
    }

    /**
     * Whether a step may take effect unreported. Not while a finding is unreported: a finding made before the effect
     * would then be reported after it.
     */
    boolean mayHideEffects() {
        return unreported.stream().noneMatch(token -> token instanceof Token.Seen);
    }

    /** Whether the new model would stay where it is if the device were found there. */
    boolean isTogether(Configuration at) {
        return rules().table().isFollowed(at);
    }

    private boolean mayPart(Output.Ended ended) {
        boolean follows = ended.decision() instanceof Decision.Resynchronization;
        return (ended.outcome() != Outcome.HANDLED && !follows)
                || ended.decision() instanceof Decision.Sending
                || !rules().table().configurations().contains(ended.before());
    }

    /** Continues after the core has received an input. */
    void heard(Input input, List<Output> said, Snapshot after) {
        Work work = after.work();
        if (input instanceof Input.Sending && (work == null || !work.sending())) {
            noLongerSent();
        }
        for (Output output : said) {
            if (output instanceof Output.Begin) {
                plans.clear();
            } else if (output instanceof Output.Start start) {
                functionOf = start.visit();
            } else if (output instanceof Output.Ended ended && mayPart(ended)) {
                mayBeApart = true;
            } else if (output instanceof Output.Send
                    || output instanceof Output.Run
                    || output instanceof Output.Locate) {
                asked = (Output.Directive) output;
                answer = null;
            }
        }
        mayBeApart &= !isTogether(after.at());
        if (work == null || work.decision() == null) {
            asked = null;
            answer = null;
        }
        if (work == null || work.decision() != null) {
            plans.clear();
        } else {
            for (Set<String> holding : Answers.of(rules().table().models())) {
                plans.add(rules().decide(after.at(), after.steps(), work.pending(), holding::contains));
            }
        }
    }
}
