package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.core.Scene.Act;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/** What the device does next, and what its adapter tells of it. */
final class Living {
    /** So much may have happened at the device without having been told. */
    private static final int MOST_UNTOLD = 2;

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
        if (world.untold.size() < MOST_UNTOLD) {
            living.actsByItself();
        }
        living.tells();
        return living.found;
    }

    private void takesSteps() {
        World.Flight flight = world.flight;
        if (flight != null && !world.landed) {
            World next = landing(flight);
            next.landed = true;
            found.add(Move.unnoticed("the device takes " + flight.step().trigger(), next));
        }
        World.Flight stray = world.stray;
        if (stray != null) {
            World told = landing(stray);
            told.stray = null;
            found.add(Move.unnoticed("the device takes " + stray.step().trigger() + ", which was given up", told));
            if (world.mayHideEffects()) {
                World hidden = world.copy();
                hidden.take(stray.step().trigger());
                hidden.stray = null;
                found.add(Move.unnoticed("the device takes " + stray.step().trigger() + " and nobody is told", hidden));
            }
        }
    }

    private World landing(World.Flight flight) {
        World next = world.copy();
        next.take(flight.step().trigger());
        next.untold.add(new Token.Effect(flight.number()));
        return next;
    }

    private void actsByItself() {
        if (world.may(Act.OWN)) {
            for (Event event : world.scene.own()) {
                if (model().hasTransition(world.device, event)) {
                    World next = world.spent(Act.OWN);
                    next.take(event);
                    next.untold.add(new Token.Own(event));
                    found.add(Move.unnoticed("the device does " + event + " by itself", next));
                }
            }
        }
        if (world.may(Act.JUMP)) {
            for (State state : model().states()) {
                World next = world.spent(Act.JUMP);
                next.device = state;
                next.stray = null;
                next.untold.add(new Token.Seen(state));
                found.add(Move.unnoticed("the device gets to " + state, next));
                if (now.steps() > 0) {
                    Occurrence late = new Occurrence.Found(state, now.lastStepNanos() - 1);
                    found.add(Move.told(new Input.Observed(late), world.spent(Act.JUMP)));
                }
            }
        }
    }

    private StateMachine model() {
        return world.rules().table().models().original();
    }

    /**
     * An adapter that keeps the order tells what happened first; another tells facts while an effect waits for its
     * turn.
     */
    private void tells() {
        for (int index = 0; index < world.untold.size(); index++) {
            Token token = world.untold.get(index);
            boolean effect = token instanceof Token.Effect;
            if (index == 0 || (!world.scene.inOrder() && !effect)) {
                World next = world.copy();
                next.untold.remove(index);
                found.add(tells(token, next));
            }
            if (!effect) {
                return;
            }
        }
    }

    private Move tells(Token token, World next) {
        if (token instanceof Token.Own own) {
            boolean alone = world.rules().table().isDevicesOwn(own.event());
            return Move.told(
                    new Input.Observed(new Occurrence.Heard(
                            own.event(), Values.NONE, Source.DEVICE, !alone, Set.of(), Occurrence.ANY_VISIT, time)),
                    next);
        }
        if (token instanceof Token.Seen seen) {
            next.stray = null;
            return Move.told(new Input.Observed(new Occurrence.Found(seen.state(), time)), next);
        }
        long number = ((Token.Effect) token).number();
        if (next.flight != null && next.flight.number() == number) {
            next.noLongerSent();
        }
        return Move.told(new Input.Sent(number, world.scene.inOrder(), time), next);
    }
}
