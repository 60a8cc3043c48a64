package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.engine.Scene.Act;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/** What the device can do next, and what its adapter can report. */
final class Living {
    /** The most events at the device that are not yet reported. */
    private static final int MOST_UNREPORTED = 2;

    private final Snapshot now;
    private final World world;
    private final long time;
    private final List<Move> found = new ArrayList<>();

    private Living(Snapshot now, World world, long time) {
        this.now = now;
        this.world = world;
        this.time = time;
    }

    static List<Move> of(Snapshot now, World world, long time) {
        Living living = new Living(now, world, time);
        living.takesSteps();
        if (world.unreported.size() < MOST_UNREPORTED) {
            living.actsByItself();
        }
        living.reports();
        return living.found;
    }

    private void takesSteps() {
        World.Flight flight = world.flight;
        if (flight != null && !world.landed) {
            for (State state : world.after(flight.step())) {
                World next = landing(flight, state);
                next.landed = true;
                found.add(Move.unnoticed(taking(flight, state), next));
            }
        }
        World.Flight stray = world.stray;
        if (stray != null) {
            for (State state : world.after(stray.step())) {
                takesLate(stray, state);
            }
        }
    }

    private void takesLate(World.Flight stray, State state) {
        World next = landing(stray, state);
        next.stray = null;
        found.add(Move.unnoticed(taking(stray, state) + ", which was given up", next));
        if (world.mayHideEffects()) {
            World hidden = world.copy();
            hidden.device = state;
            hidden.stray = null;
            found.add(Move.unnoticed(taking(stray, state) + ", unreported", hidden));
        }
    }

    private String taking(World.Flight flight, State state) {
        Step step = flight.step();
        return "the device takes " + step.trigger() + (world.after(step).size() > 1 ? " to " + state : "");
    }

    private World landing(World.Flight flight, State state) {
        World next = world.copy();
        next.device = state;
        next.unreported.add(new Token.Effect(flight.number()));
        return next;
    }

    private void actsByItself() {
        if (world.may(Act.OWN)) {
            for (Event event : world.scene.own()) {
                if (model().hasTrigger(world.device, event)) {
                    does(event);
                }
            }
        }
        if (world.may(Act.JUMP)) {
            for (State state : model().states()) {
                World next = world.spent(Act.JUMP);
                next.device = state;
                next.stray = null;
                next.unreported.add(new Token.Seen(state));
                found.add(Move.unnoticed("the device gets to " + state, next));
                if (now.steps() > 0) {
                    Occurrence late = new Occurrence.Found(state, now.lastStepNanos() - 1);
                    found.add(Move.noticed(new Input.Observed(late), world.spent(Act.JUMP)));
                }
            }
        }
    }

    private void does(Event event) {
        for (Set<String> holding : Answers.of(models(), event)) {
            World next = world.spent(Act.OWN);
            next.device = world.after(event, holding);
            next.unreported.add(new Token.Own(event, holding));
            String open = holding.isEmpty() ? "" : " " + holding;
            found.add(Move.unnoticed("the device does " + event + open + " by itself", next));
        }
    }

    private ModelPair models() {
        return world.rules().table().models();
    }

    private StateMachine model() {
        return models().original();
    }

    /**
     * An adapter that keeps the order reports what happened first; another may report facts before an earlier effect.
     */
    private void reports() {
        if (world.may(Act.LOSE) && !world.unreported.isEmpty() && world.unreported.get(0) instanceof Token.Own lost) {
            World next = world.spent(Act.LOSE);
            next.unreported.remove(0);
            next.misled = true;
            found.add(Move.unnoticed("the report of " + lost.event() + " is lost", next));
        }
        for (int index = 0; index < world.unreported.size(); index++) {
            Token token = world.unreported.get(index);
            boolean effect = token instanceof Token.Effect;
            if (index == 0 || (!world.scene.inOrder() && !effect)) {
                World next = world.copy();
                next.unreported.remove(index);
                found.add(reports(token, next));
            }
            if (!effect) {
                return;
            }
        }
    }

    private Move reports(Token token, World next) {
        if (token instanceof Token.Own own) {
            boolean alone = world.rules().table().isDevicesOwn(own.event());
            return Move.noticed(
                    new Input.Observed(new Occurrence.Heard(
                            own.event(),
                            Values.NONE,
                            Source.DEVICE,
                            !alone,
                            own.holding(),
                            Occurrence.ANY_VISIT,
                            time)),
                    next);
        }
        if (token instanceof Token.Seen seen) {
            next.stray = null;
            return Move.noticed(new Input.Observed(new Occurrence.Found(seen.state(), time)), next);
        }
        long number = ((Token.Effect) token).number();
        if (next.flight != null && next.flight.number() == number) {
            next.noLongerSent();
        }
        return Move.noticed(new Input.Sent(number, world.scene.inOrder(), time), next);
    }
}
