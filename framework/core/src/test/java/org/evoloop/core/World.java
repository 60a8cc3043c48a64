package org.evoloop.core;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * What is around a core: the device as it truly is, what is on its way, and what the components have been told to do.
 */
final class World {
    /** Whether the converter takes controllers' events. */
    enum Phase {
        CLOSED,
        OPEN,
        CLOSING
    }

    /** A step on its way to the device. */
    record Flight(long number, Step step) {}

    final Scene scene;
    State device;
    /** In the order in which it happened. */
    List<Token> untold = new ArrayList<>();

    /** What is being sent; null if nothing is. */
    @Nullable
    Flight flight;
    /** Whether that has had its effect. */
    boolean landed;
    /** A step that was given up and may still have its effect, but not after the device has told where it is. */
    @Nullable
    Flight stray;
    /** What the components have to do for the occurrence in progress. */
    Output.@Nullable Directive asked;
    /** Where the device said that it is. */
    @Nullable
    State answer;
    /** What analyze may have decided since the occurrence began, on what it saw then. */
    Set<Decision> plans = new LinkedHashSet<>();

    Phase phase = Phase.CLOSED;
    /** Whether it goes by the scene's next rules. */
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
        untold = new ArrayList<>(same.untold);
        flight = same.flight;
        landed = same.landed;
        stray = same.stray;
        asked = same.asked;
        answer = same.answer;
        plans = new LinkedHashSet<>(same.plans);
        phase = same.phase;
        evolved = same.evolved;
        left = new EnumMap<>(same.left);
    }

    World copy() {
        return new World(this);
    }

    /** By what the core goes now. */
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

    /** What the device's model does on {@code trigger}. */
    void take(Event trigger) {
        device = rules().table().models().original().nextState(device, trigger).orElse(device);
    }

    void noLongerSent() {
        flight = null;
        landed = false;
    }

    /**
     * Whether a step may have its effect without being told: what was found before that has been told, so it is older.
     */
    boolean mayHideEffects() {
        return untold.stream().noneMatch(token -> token instanceof Token.Seen);
    }

    /** Goes on after the core was told something. */
    void heard(Input input, List<Output> said, Snapshot after) {
        Work work = after.work();
        if (input instanceof Input.Sending && (work == null || !work.sending())) {
            noLongerSent();
        }
        for (Output output : said) {
            if (output instanceof Output.Begin) {
                plans.clear();
            } else if (output instanceof Output.Send
                    || output instanceof Output.Run
                    || output instanceof Output.Locate) {
                asked = (Output.Directive) output;
                answer = null;
            }
        }
        if (work == null || work.decision() == null) {
            asked = null;
            answer = null;
        }
        if (work == null || work.decision() != null) {
            plans.clear();
        } else {
            plans.add(rules().decide(after.at(), after.steps(), work.pending(), guard -> false));
        }
    }
}
