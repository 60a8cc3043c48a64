package org.evoloop.roomba;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.link.LinkException;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends events to the robot as commands, and keeps it in the mode that each state needs. In standby and while cleaning
 * it is left in Passive mode. When it is on and idle it is kept in Safe mode, so that its buttons do not act on their
 * own. On its dock it is also left in Passive mode: there it would leave Safe mode at once and stop charging. If its
 * model has a state {@code Asleep}, it may fall asleep when unused, and is woken for the next event.
 *
 * <p>If the mode shows that a command has taken effect, that is reported when it is seen, on the thread that reports
 * the robot's own actions; otherwise the command counts as obeyed when it has been sent.
 */
final class ExecuteCommand extends EventExecute implements SessionListener {
    /** The robot does not acknowledge commands; it is assumed to be ready this long after one. */
    static final Duration HOLD_OFF = Duration.ofMillis(200);

    /** How long an unused robot is kept under control. */
    static final Duration UNUSED_LIMIT = Duration.ofMinutes(5);

    private static final Set<String> SHOWN_BY_CIRCUMSTANCES = Set.of(
            RobotEvents.STATE_ASLEEP, RobotEvents.STATE_ERROR, RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED);

    private static final Logger LOG = LoggerFactory.getLogger(ExecuteCommand.class);

    private final RoombaSession session;
    private final Clock clock;
    private final Resumption resumption;
    private final StateMachine original;
    private final boolean sleeps;
    private final Object resting = new Object();
    private Clock.@Nullable Timer unused;
    private volatile @Nullable Command sent;
    private boolean commanded;
    private long commandedNanos;

    /** @param original the robot's model */
    ExecuteCommand(RoombaSession session, StateMachine original, Clock clock, Resumption resumption) {
        this.original = original;
        this.sleeps = original.hasState(new State(RobotEvents.STATE_ASLEEP));
        this.session = session;
        this.clock = clock;
        this.resumption = resumption;
        session.addListener(this);
    }

    @Override
    protected Set<String> sendableEvents() {
        Set<String> known = new LinkedHashSet<>(RobotEvents.COMMANDS);
        known.retainAll(original.triggers().stream().map(Event::name).toList());
        return known;
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        long leftNanos = HOLD_OFF.toNanos() - (clock.nanoTime() - commandedNanos);
        if (commanded && leftNanos > 0 && session.mayWait()) {
            clock.sleep(Duration.ofNanos(leftNanos));
        }
    }

    @Override
    protected void send(Step step) throws InterruptedException, UnknownEffectException {
        stayAwake();
        if (step.source().name().equals(RobotEvents.STATE_ASLEEP)) {
            session.wake();
        } else if (step.event().name().equals(RobotEvents.UNDOCK)) {
            session.leaveAlone();
            requireKnown(session.leaveDock());
        } else {
            send(command(step));
        }
    }

    private void send(Command command) throws InterruptedException, UnknownEffectException {
        sent = command;
        session.send(command);
        // Only after sending: while control is wanted, no frame shows that the robot is idle.
        session.leaveAlone();
        commanded = true;
        commandedNanos = clock.nanoTime();
        requireKnown(session.awaitEffect());
    }

    private void requireKnown(boolean effect) throws UnknownEffectException {
        if (!effect) {
            throw new UnknownEffectException(session.describe());
        }
    }

    @Override
    public void obeyed(Command command) {
        // Commands other than the last step's keep the robot in its mode.
        if (command == sent) {
            tookEffect();
        }
    }

    @Override
    protected Optional<String> locate() throws InterruptedException {
        if (session.isAsleep() && sleeps) {
            return Optional.of(RobotEvents.STATE_ASLEEP);
        }
        Optional<String> state = session.awaitActivity()
                .flatMap(activity -> RobotEvents.stateName(original, activity, session.circumstances()));
        state.ifPresent(this::keepMode);
        return state;
    }

    private static Command command(Step step) {
        String source = step.source().name();
        boolean onlyOn = source.equals(RobotEvents.STATE_OFF) || source.equals(RobotEvents.STATE_ERROR);
        return switch (step.event().name()) {
            // The command Clean would start cleaning directly from standby; taking control only switches the robot on.
            case RobotEvents.CLEAN -> onlyOn ? new Command.Safe() : new Command.Clean();
            case RobotEvents.SPOT -> new Command.Spot();
            case RobotEvents.DOCK -> new Command.SeekDock();
            case RobotEvents.MAX -> new Command.Max();
            case RobotEvents.POWER -> new Command.Power();
            default -> throw new IllegalArgumentException("the robot has no command for " + step.event());
        };
    }

    @Override
    protected void settled(Configuration now) {
        resumption.settled();
        keepMode(now.original().name());
        if (!SHOWN_BY_CIRCUMSTANCES.contains(now.original().name()) && !session.isUndocking()) {
            // A robot that is lifted or on its dock may not be in the recorded state.
            session.reportAgain();
        }
        if (now.evolved().equals(now.original()) && now.original().name().equals(RobotEvents.STATE_ON)) {
            restLater();
        }
    }

    private void keepMode(String state) {
        if (state.equals(RobotEvents.STATE_ON)) {
            session.takeControl();
        } else {
            session.leaveAlone();
            session.letSleep(sleeps);
        }
    }

    /**
     * Releases control of an unused robot that is on, so that it may fall asleep and does not drain its battery.
     */
    private void restLater() {
        synchronized (resting) {
            stayAwake();
            if (sleeps) {
                unused = clock.schedule(UNUSED_LIMIT, this::rest);
            }
        }
    }

    private void rest() {
        synchronized (resting) {
            if (unused != null) {
                unused = null;
                try {
                    session.rest();
                } catch (LinkException | RobotException gone) {
                    LOG.debug("{}", gone.getMessage());
                }
            }
        }
    }

    private void stayAwake() {
        synchronized (resting) {
            if (unused != null) {
                unused.cancel();
                unused = null;
            }
        }
    }

    @Override
    protected void released() {
        stayAwake();
        resumption.released();
        session.release();
    }
}
