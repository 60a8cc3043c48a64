package org.evoloop.roomba.session;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.IntFunction;
import org.evoloop.link.Link;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFramer;
import org.evoloop.roomba.session.connection.ConnectionOptions;
import org.evoloop.roomba.session.connection.ConnectionOwner;
import org.evoloop.roomba.session.connection.FirstBytes;
import org.evoloop.roomba.session.connection.RobotConnection;
import org.evoloop.roomba.session.inference.ActivityEstimate;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.ButtonPresses;
import org.evoloop.roomba.session.inference.CircumstanceWatch;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.roomba.session.inference.CommandEffect;
import org.evoloop.roomba.session.inference.FrameFilter;
import org.evoloop.roomba.session.inference.ModeOffset;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Decodes the robot's bytes into frames, infers its activity from them, and notifies listeners: of presses of its
 * buttons, the end of a spot cleaning, and its activity.
 *
 * <p>Threading: thread-safe; listeners are called on the thread that reads, one call at a time.
 */
final class RobotReader implements ConnectionOwner {
    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    private static final int BUFFER_BYTES = 4_096;

    /** This many frames with a wrong checksum, and none with a right one, cannot be due to noise. */
    private static final int SIGNIFICANT_FRAMES = 20;

    private final Clock clock;
    private final RobotConnection connection;
    private final List<SessionListener> listeners = new CopyOnWriteArrayList<>();
    private final FirstBytes firstBytes = new FirstBytes();
    private final StreamFramer framer = new StreamFramer(RoombaSession.STREAM);
    private final ModeOffset modeOffset;
    private final FrameFilter filter;
    private final Odometry odometry = new Odometry();
    private final ButtonPresses buttons = new ButtonPresses();
    private final SpotWatch spotWatch = new SpotWatch();
    private final ActivityEstimate estimate = new ActivityEstimate();
    private final CommandEffect effect = new CommandEffect();
    private final Control control;
    private final Undocking undocking;
    private final CircumstanceWatch circumstances = new CircumstanceWatch();
    private Circumstances reported = Circumstances.USUAL;
    private boolean reportAgain;
    private int framesUntilReport;
    private volatile @Nullable Telemetry latest;

    /** @param cable opens a new link to the robot at a baud rate; called again whenever the link was lost */
    RobotReader(IntFunction<Link> cable, Clock clock, SessionOptions options) {
        this.clock = clock;
        this.modeOffset = new ModeOffset(options.modeOffset());
        this.filter = new FrameFilter(modeOffset);
        ConnectionOptions wanted =
                new ConnectionOptions(RoombaSession.STREAM, options.silenceLimit(), options.mayWait());
        this.connection = new RobotConnection(cable, clock, wanted, this);
        this.control = new Control(connection, estimate);
        this.undocking = new Undocking(connection::trySend, estimate);
    }

    RobotConnection connection() {
        return connection;
    }

    /** The robot's control; callers must hold the monitor of this object. */
    Control control() {
        return control;
    }

    void addListener(SessionListener listener) {
        listeners.add(listener);
    }

    void removeListener(SessionListener listener) {
        listeners.remove(listener);
    }

    /** The contents of the last frame; null before the first. */
    @Nullable
    Telemetry latest() {
        return latest;
    }

    @Override
    public void read(Link link) {
        byte[] buffer = new byte[BUFFER_BYTES];
        for (int length = link.receive(buffer); length > 0; length = link.receive(buffer)) {
            connection.stirred();
            firstBytes.take(buffer, length);
            take(buffer, length);
        }
    }

    private void take(byte[] buffer, int length) {
        for (SensorValues reported : frames(buffer, length)) {
            for (Button button : look(reported)) {
                // Without the monitor: the thread that handles the press needs it, to send a command. In
                // a loop: creating a lambda stays interpreted, which is slow, as long as presses are rare.
                for (SessionListener listener : listeners) {
                    listener.pressed(button, false);
                }
            }
        }
    }

    private synchronized List<SensorValues> frames(byte[] buffer, int length) {
        return framer.feed(buffer, 0, length);
    }

    /** Returns the buttons that were pressed and on which the robot, which is under control, does not act. */
    private synchronized Set<Button> look(SensorValues reported) {
        learnModeOffset(reported.value(Packet.OI_MODE));
        return modeOffset.isKnown() ? framed(filter.filter(reported)) : Set.of();
    }

    private Set<Button> framed(SensorValues values) {
        Telemetry earlier = latest;
        Telemetry now = new Telemetry(earlier == null ? 1 : earlier.frame() + 1, values, odometry.update(values));
        // Publish the telemetry before completing the first answer: threads that wait for the answer read it.
        latest = now;
        connection.answered();
        for (SessionListener listener : listeners) {
            listener.received(now);
        }
        long nowNanos = clock.nanoTime();
        Command obeyed = effect.update(values, now.isUnderControl(), nowNanos);
        if (obeyed != null) {
            listeners.forEach(listener -> listener.obeyed(obeyed));
        }
        boolean again = reportAgain;
        if (circumstances.update(values, estimate.activity().isWork()) || (again && circumstances.isSure())) {
            reportCircumstances(again ? Circumstances.USUAL : reported);
        }
        reportAgain |= undocking.update(now);
        switch (control.update(now, nowNanos)) {
            case ON -> {
                estimate.controlled();
                reportSeen(EstimatedActivity.ON);
            }
            case AS_ESTIMATED -> reportActivity();
            case NOTHING -> {}
        }
        Set<Button> pressed = buttons.update(values.buttons());
        if (!now.isUnderControl()) {
            pressed.forEach(this::robotActsOn);
        }
        SpotWatch.SpotEnd ending = spotWatch.update(values, nowNanos);
        if (ending != null) {
            estimate.seenAtRest();
            listeners.forEach(listener -> listener.spotEnded(ending));
        }
        boolean seen = estimate.update(values, now.isUnderControl(), !control.isWanted(), nowNanos);
        // After reporting the end of a spot cleaning, report nothing else, so that its effects are handled first.
        if (seen && ending == null) {
            reportActivity();
        }
        if (framesUntilReport > 0 && --framesUntilReport == 0) {
            reportSeen(estimate.activity());
        }
        return now.isUnderControl() ? pressed : Set.of();
    }

    private void reportCircumstances(Circumstances before) {
        reportAgain = false;
        Circumstances now = circumstances.now();
        reported = now;
        listeners.forEach(listener -> listener.changed(before, now, estimate.activity()));
    }

    /**
     * Drives the robot, which is in Full mode, off its dock, until it is clear of it or something else drives it. Does
     * nothing if it is out of sight: it must not start to drive when it is back.
     */
    synchronized void beginUndocking() {
        Telemetry now = latest;
        if (now != null && connection.isUp()) {
            undocking.begin(now);
        }
    }

    /** Whether the robot is driving off its dock. */
    synchronized boolean isUndocking() {
        return undocking.isUnderWay();
    }

    /** Stops the robot if it is driving off its dock. */
    synchronized void endUndocking() {
        undocking.end();
    }

    /** Reports the robot's activity soon, unless a command is sent first. */
    synchronized void reportSoon() {
        framesUntilReport = CommandEffect.SHOW_FRAMES;
    }

    /** Reports the robot's circumstances with the next frame, even if they have not changed. */
    synchronized void reportAgain() {
        reportAgain = true;
    }

    private void robotActsOn(Button button) {
        for (SessionListener listener : listeners) {
            listener.pressed(button, true);
        }
        reportAgain |= undocking.giveUp();
        estimate.pressed(button);
        if (estimate.activity() == EstimatedActivity.SPOT) {
            spotWatch.started();
        } else {
            spotWatch.forget();
        }
        reportActivity();
    }

    /** Reports the robot's activity. */
    private void reportActivity() {
        // The frames do not distinguish stand-by from on.
        if (estimate.activity() != EstimatedActivity.STANDBY) {
            reportSeen(estimate.activity());
        }
    }

    private void reportSeen(EstimatedActivity activity) {
        listeners.forEach(listener -> listener.seen(activity));
    }

    private void learnModeOffset(int reported) {
        int before = modeOffset.value();
        if (modeOffset.update(reported)) {
            connection.trySend(new Command.Start());
        }
        if (modeOffset.value() != before) {
            LOG.warn(
                    "{}: the robot reports its mode {}; modes are read accordingly",
                    connection.description(),
                    modeOffset.value() == 1 ? "one too high, as some 600 models do" : "as specified");
        }
    }

    /** Sets the activity that another process last reported. */
    synchronized void assume(EstimatedActivity last) {
        estimate.assume(last);
        if (last == EstimatedActivity.SPOT) {
            spotWatch.started();
        }
    }

    /** A command is about to be sent. */
    synchronized void sending(Command command) {
        effect.sending(command);
        control.sending(command);
    }

    /** Whether the effect of the last command has not been seen yet. */
    synchronized boolean isEffectAwaited() {
        return effect.isAwaited();
    }

    /**
     * The robot's activity, if its frames show it with certainty; then a command without that effect is not repeated.
     * Null if they do not, or not yet.
     *
     * @param since the number of a frame; only newer frames count
     */
    synchronized @Nullable EstimatedActivity known(long since) {
        Telemetry now = latest;
        if (now == null || now.frame() <= since || !effect.isOver() || control.isRegaining()) {
            return null;
        }
        if (now.isUnderControl()) {
            control.forgetCommand();
            return EstimatedActivity.ON;
        }
        return effect.isMissing() || !estimate.isSure() ? null : estimate.activity();
    }

    /** The robot's circumstances after the frames so far. */
    synchronized Circumstances circumstances() {
        return circumstances.now();
    }

    /** A command has been sent. */
    synchronized void commanded(Command command) {
        framesUntilReport = 0;
        reportAgain |= undocking.giveUp();
        control.commanded(command);
        estimate.commanded(command);
        if (command instanceof Command.Spot && estimate.activity() == EstimatedActivity.SPOT) {
            spotWatch.started();
        }
    }

    /** The robot was stopped from outside. */
    synchronized void stoppedByOthers(String why) {
        listeners.forEach(listener -> listener.stopped(why));
    }

    /** Earlier frames no longer count. */
    @Override
    public synchronized void outOfSight() {
        control.loseSight();
        spotWatch.forget();
        estimate.forget();
        undocking.end();
        circumstances.forget();
        reportAgain = true;
    }

    @Override
    public synchronized boolean isDrowsy() {
        return circumstances.isDrowsy();
    }

    @Override
    public synchronized void fellAsleep() {
        estimate.fellAsleep();
        if (circumstances.fellAsleep()) {
            reportCircumstances(reported);
        }
    }

    @Override
    public synchronized void keptAwake() {
        circumstances.keptAwake();
    }

    @Override
    public FirstBytes firstBytes() {
        return firstBytes;
    }

    /** Frames in which only the checksum is wrong do not indicate a wrong baud rate. */
    @Override
    public synchronized String frameTrouble() {
        if (framer.frames() > 0 || framer.badChecksums() < SIGNIFICANT_FRAMES) {
            return "";
        }
        return 2 * framer.headerlessChecksums() > framer.badChecksums()
                ? "frames come, but their checksum leaves out the header byte, as the Roomba 500's specification says "
                        + "but no known robot does. A simulated robot does so with --checksum spec500: start it without"
                : "frames come, but their checksum never fits: the cable or its adapter changes bytes. Try another one";
    }

    @Override
    public synchronized boolean isDozing() {
        Telemetry now = latest;
        return (now == null || !now.isUnderControl()) && estimate.isAtRest();
    }

    /** The mode of the last frame, and the numbers of good and bad frames. */
    synchronized String describe(Telemetry now) {
        String mode = now.values()
                .mode()
                .map(known -> known.name().toLowerCase(Locale.ROOT))
                .orElse("unknown");
        return "mode " + mode + (modeOffset.value() == 0 ? "" : " (reported one too high)") + ", " + framer.frames()
                + " frames, " + framer.badChecksums() + " bad, " + framer.skippedBytes() + " bytes skipped";
    }
}
