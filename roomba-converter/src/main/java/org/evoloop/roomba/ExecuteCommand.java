package org.evoloop.roomba;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Sends events to the robot as commands, and keeps it in the mode that each state needs: while it stands by or cleans it
 * is left to itself (Passive), while it is on and idle its buttons must not act on their own (Safe).
 *
 * <p>Where the mode shows that a command has had its effect, that is told when it is seen, on the thread that tells what the
 * robot does by itself; elsewhere the command counts as obeyed when it has been sent.
 */
final class ExecuteCommand extends EventExecute implements SessionListener {
    /** The robot tells nobody when it has digested a command; so long after one it is taken to be ready again. */
    static final Duration HOLD_OFF = Duration.ofMillis(200);

    private final RoombaSession session;
    private final Clock clock;
    private final Resumption resumption;
    private volatile @Nullable Command sent;
    private boolean commanded;
    private long commandedNanos;

    ExecuteCommand(RoombaSession session, Clock clock, Resumption resumption) {
        this.session = session;
        this.clock = clock;
        this.resumption = resumption;
        session.addListener(this);
    }

    @Override
    protected Set<String> sendableEvents() {
        return Set.of(RobotEvents.CLEAN, RobotEvents.SPOT);
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        long leftNanos = HOLD_OFF.toNanos() - (clock.nanoTime() - commandedNanos);
        if (commanded && leftNanos > 0 && session.mayWait()) {
            clock.sleep(Duration.ofNanos(leftNanos));
        }
    }

    @Override
    protected void send(Step step) throws InterruptedException {
        Command command = command(step);
        sent = command;
        session.send(command);
        // Not before: while control is wanted, no frame tells that the robot does nothing.
        session.leaveAlone();
        commanded = true;
        commandedNanos = clock.nanoTime();
        session.awaitEffect();
    }

    @Override
    public void obeyed(Command command) {
        // Others than the last step's are sent to keep the robot in its mode.
        if (command == sent) {
            tookEffect();
        }
    }

    @Override
    protected Optional<String> locate() throws InterruptedException {
        Optional<String> state = session.awaitActivity().flatMap(RobotEvents::stateName);
        state.ifPresent(this::keepMode);
        return state;
    }

    private static Command command(Step step) {
        boolean standsBy = step.source().name().equals(RobotEvents.STATE_OFF);
        return switch (step.event().name()) {
            // The command Clean would start to clean straight from stand-by; taking control only switches the robot on.
            case RobotEvents.CLEAN -> standsBy ? new Command.Safe() : new Command.Clean();
            case RobotEvents.SPOT -> new Command.Spot();
            default -> throw new IllegalArgumentException("the robot has no command for " + step.event());
        };
    }

    @Override
    protected void settled(Configuration now) {
        resumption.settled();
        keepMode(now.original().name());
    }

    private void keepMode(String state) {
        if (state.equals(RobotEvents.STATE_ON)) {
            session.takeControl();
        } else {
            session.leaveAlone();
        }
    }

    @Override
    protected void released() {
        resumption.released();
        session.letGo();
    }
}
