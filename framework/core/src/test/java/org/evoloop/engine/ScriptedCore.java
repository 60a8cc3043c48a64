package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** Gives a core one input after another, with methods that read like a story. */
final class ScriptedCore {
    final Core core;
    final List<Output> said = new ArrayList<>();
    private long now;

    ScriptedCore(Scene scene) {
        core = new Core(scene.rules(), said::add);
        input(new Input.Opened(now));
    }

    ScriptedCore input(Input input) {
        core.apply(input);
        now++;
        return this;
    }

    ScriptedCore press(String event) {
        return observe(heard(event, Source.CONTROLLER, false));
    }

    /** The device has done this by itself. */
    ScriptedCore own(String event) {
        return observe(heard(event, Source.DEVICE, true));
    }

    ScriptedCore found(String state) {
        return observe(new Occurrence.Found(new State(state), now));
    }

    ScriptedCore observe(Occurrence occurrence) {
        return input(new Input.Observed(occurrence));
    }

    private Occurrence heard(String event, Source source, boolean acted) {
        return new Occurrence.Heard(new Event(event), Values.NONE, source, acted, Set.of(), Occurrence.ANY_VISIT, now);
    }

    /** Begins the next occurrence. */
    ScriptedCore ready() {
        return input(new Input.Ready());
    }

    /** Decides the occurrence in progress on the present states. */
    ScriptedCore planned() {
        Work work = work();
        return input(new Input.Planned(
                number(), core.rules().decide(core.at(), core.steps(), work.pending(), guard -> false), now));
    }

    ScriptedCore sending() {
        return input(new Input.Sending(number()));
    }

    /** Begins and plans the next occurrence, and starts sending its first step. */
    ScriptedCore begins() {
        return ready().planned().sending();
    }

    ScriptedCore sent(boolean inOrder) {
        return sent(number(), inOrder);
    }

    ScriptedCore sent(long number, boolean inOrder) {
        return input(new Input.Sent(number, inOrder, now));
    }

    ScriptedCore givenUp() {
        return input(new Input.GivenUp(number(), "it was given up", now));
    }

    ScriptedCore runsEffect() {
        return input(new Input.Running(number())).input(new Input.EffectRun(number(), "", now));
    }

    /** The device is asked for its state and cannot report it. */
    ScriptedCore asksInVain() {
        ready().planned();
        return input(new Input.Located(number(), null, now));
    }

    ScriptedCore located(String state) {
        return input(new Input.Located(number(), new State(state), now));
    }

    /** The number of the occurrence in progress. */
    long number() {
        return work().pending().number();
    }

    Work work() {
        Work work = core.snapshot().work();
        if (work == null) {
            throw new AssertionError("nothing is in progress");
        }
        return work;
    }

    /** The recorded state of the device, and whether it is in doubt. */
    String record() {
        return core.at().original() + (core.doubt().isEmpty() ? "" : ", in doubt");
    }
}
