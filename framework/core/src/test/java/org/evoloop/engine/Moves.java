package org.evoloop.engine;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import org.evoloop.engine.Scene.Act;
import org.evoloop.engine.World.Phase;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** Everything that can happen next from outside: acts of people, timers, functions and the converter's program. */
final class Moves {
    private final Snapshot now;
    private final World world;
    private final long time;
    private final List<Move> found = new ArrayList<>();

    private Moves(Snapshot now, World world, long time) {
        this.now = now;
        this.world = world;
        this.time = time;
    }

    /** @param time the time of the inputs */
    static List<Move> of(Snapshot now, World world, long time) {
        Moves moves = new Moves(now, world, time);
        moves.found.addAll(Carrying.of(now, world, time));
        moves.found.addAll(Living.of(now, world, time));
        moves.press();
        moves.raise();
        moves.timers();
        moves.lifecycle();
        return moves.found;
    }

    /**
     * A random one; null if nothing can happen. Mostly something goes on that has begun: else hardly any plan would come
     * to its end.
     */
    static @Nullable Move any(Snapshot now, World world, long time, Random random) {
        List<Move> all = of(now, world, time);
        List<Move> usual = all.stream()
                .filter(move -> move.world().left.equals(world.left))
                .toList();
        List<Move> from = usual.isEmpty() || random.nextInt(4) == 0 ? all : usual;
        return from.isEmpty() ? null : from.get(random.nextInt(from.size()));
    }

    private void press() {
        if (world.may(Act.PRESS)) {
            for (Event event : world.scene.presses()) {
                observe(Act.PRESS, event, Source.CONTROLLER, Occurrence.ANY_VISIT);
            }
        }
    }

    private void raise() {
        for (long visit : visits()) {
            if (world.may(Act.RAISE)) {
                for (Event event : world.scene.raised()) {
                    observe(Act.RAISE, event, Source.FUNCTION, visit);
                }
            }
            if (world.may(Act.ASK)) {
                for (Event event : world.scene.presses()) {
                    Occurrence asked = new Occurrence.Asked(event, Values.NONE, visit, time);
                    found.add(Move.noticed(new Input.Observed(asked), world.spent(Act.ASK)));
                }
            }
        }
    }

    /** The current visit and the previous one, whose function may not have noticed that it is over. */
    private Set<Long> visits() {
        Set<Long> visits = new LinkedHashSet<>();
        long last = now.visit().number();
        for (long visit = Math.max(1, last - 1); visit <= last; visit++) {
            visits.add(visit);
        }
        return visits;
    }

    private void observe(Act act, Event event, Source source, long visit) {
        Occurrence heard = new Occurrence.Heard(event, Values.NONE, source, visit, time);
        found.add(Move.noticed(new Input.Observed(heard), world.spent(act)));
    }

    private void timers() {
        long visit = now.visit().number();
        now.visit().deadlines().forEach((event, due) -> {
            if (!hasFired(event, visit)) {
                found.add(Move.noticed(new Input.TimerDue(visit, event, due), world.copy()));
            }
        });
        if (visit > 1 && world.may(Act.RAISE)) {
            for (Event event : world.scene.raised()) {
                found.add(Move.noticed(new Input.TimerDue(visit - 1, event, time), world.spent(Act.RAISE)));
            }
        }
    }

    private boolean hasFired(Event event, long visit) {
        return now.waiting().stream()
                .map(Pending::occurrence)
                .anyMatch(waiting -> waiting instanceof Occurrence.Heard heard
                        && heard.source() == Source.TIMER
                        && heard.visit() == visit
                        && heard.event().equals(event));
    }

    private void lifecycle() {
        if (world.phase == Phase.CLOSED) {
            found.add(Move.noticed(new Input.Opened(time), in(world.copy(), Phase.OPEN)));
        } else if (world.phase == Phase.CLOSING && now.work() == null) {
            found.add(Move.noticed(new Input.Closed(), in(world.copy(), Phase.CLOSED)));
        } else if (world.phase == Phase.OPEN && world.may(Act.STOP)) {
            found.add(Move.noticed(new Input.Closing(), in(world.spent(Act.STOP), Phase.CLOSING)));
        }
        if (world.may(Act.END)) {
            end();
        }
        Swap swap = world.scene.swap(world.evolved);
        if (world.may(Act.EVOLVE)
                && new Core(world.rules(), now, output -> {}).hindrance(swap).isEmpty()) {
            World next = world.spent(Act.EVOLVE);
            next.evolved = !world.evolved;
            // States that are together in neither models' table remain as they are.
            next.mayBeApart |= !world.isTogether(now.at());
            next.device = Objects.requireNonNull(swap.succession().deviceState(world.device));
            found.add(Move.noticed(new Input.Evolved(swap, time), next));
        }
        if (world.may(Act.CHANGE)) {
            found.add(Move.noticed(new Input.Changed(world.rules(), time), world.spent(Act.CHANGE)));
        }
    }

    /** What was sent may still take effect, and may be reported or not; the process that sent it is gone. */
    private void end() {
        World next = in(world.spent(Act.END), Phase.CLOSED);
        if (world.flight != null && !world.landed) {
            next.stray = world.flight;
        }
        next.noLongerSent();
        next.asked = null;
        next.answer = null;
        found.add(Move.noticed(new Input.Recovered(time), next));
        if (world.flight != null && world.landed && world.mayHideEffects()) {
            World hidden = next.copy();
            hidden.unreported.removeIf(token -> token instanceof Token.Effect);
            found.add(Move.noticed(new Input.Recovered(time), hidden));
        }
    }

    private static World in(World next, Phase phase) {
        next.phase = phase;
        return next;
    }
}
