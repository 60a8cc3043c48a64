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
            World next = landing(flight);
            next.landed = true;
            found.add(Move.unnoticed("the device takes " + flight.step().trigger(), next));
        }
        World.Flight stray = world.stray;
        if (stray != null) {
            World next = landing(stray);
            next.stray = null;
            found.add(Move.unnoticed("the device takes " + stray.step().trigger() + ", which was given up", next));
            if (world.mayHideEffects()) {
                World hidden = world.copy();
                hidden.take(stray.step().trigger());
                hidden.stray = null;
                found.add(Move.unnoticed("the device takes " + stray.step().trigger() + ", unreported", hidden));
            }
        }
    }

    private World landing(World.Flight flight) {
        World next = world.copy();
        next.take(flight.step().trigger());
        next.unreported.add(new Token.Effect(flight.number()));
        return next;
    }

    private void actsByItself() {
        if (world.may(Act.OWN)) {
            for (Event event : world.scene.own()) {
                if (model().hasTransition(world.device, event)) {
                    World next = world.spent(Act.OWN);
                    next.take(event);
                    next.unreported.add(new Token.Own(event));
                    found.add(Move.unnoticed("the device does " + event + " by itself", next));
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

    private StateMachine model() {
        return world.rules().table().models().original();
    }

    /**
     * An adapter that keeps the order reports what happened first; another may report facts before an earlier effect.
     */
    private void reports() {
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
                            own.event(), Values.NONE, Source.DEVICE, !alone, Set.of(), Occurrence.ANY_VISIT, time)),
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
