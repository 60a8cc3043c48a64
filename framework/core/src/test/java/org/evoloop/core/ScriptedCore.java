package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** A core that is told one thing after the other, in the words of a story. */
final class ScriptedCore {
    final Core core;
    final List<Output> said = new ArrayList<>();
    private long now;

    ScriptedCore(Scene scene) {
        core = new Core(scene.rules(), said::add);
        tell(new Input.Opened(now));
    }

    ScriptedCore tell(Input input) {
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
        return tell(new Input.Observed(occurrence));
    }

    private Occurrence heard(String event, Source source, boolean acted) {
        return new Occurrence.Heard(new Event(event), Values.NONE, source, acted, Set.of(), Occurrence.ANY_VISIT, now);
    }

    /** The next occurrence is begun. */
    ScriptedCore ready() {
        return tell(new Input.Ready());
    }

    /** What is in progress is decided by where things are now. */
    ScriptedCore planned() {
        Work work = work();
        return tell(new Input.Planned(
                number(), core.rules().decide(core.at(), core.steps(), work.pending(), guard -> false), now));
    }

    ScriptedCore sending() {
        return tell(new Input.Sending(number()));
    }

    /** The next occurrence is begun and planned, and its first step is on its way. */
    ScriptedCore begins() {
        return ready().planned().sending();
    }

    ScriptedCore sent(boolean inOrder) {
        return sent(number(), inOrder);
    }

    ScriptedCore sent(long number, boolean inOrder) {
        return tell(new Input.Sent(number, inOrder, now));
    }

    ScriptedCore givenUp() {
        return tell(new Input.GivenUp(number(), "it was given up", now));
    }

    /** The device is asked where it is, and cannot tell. */
    ScriptedCore asksInVain() {
        ready().planned();
        return tell(new Input.Located(number(), null, now));
    }

    ScriptedCore located(String state) {
        return tell(new Input.Located(number(), new State(state), now));
    }

    /** Of the occurrence in progress. */
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

    /** Where the record says that the device is, and whether it is in doubt. */
    String record() {
        return core.at().original() + (core.doubt().isEmpty() ? "" : ", in doubt");
    }
}
