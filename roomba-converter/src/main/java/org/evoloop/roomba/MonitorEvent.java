package org.evoloop.roomba;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.converter.PushMonitor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.evoloop.statemachine.StateMachine;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Monitors the robot: its buttons, and those of its own actions that have events in its model: finished work, docking,
 * sleep and trouble. The OI mode shows whether the robot acts on a button by itself or only reports it. If the observed
 * activity differs from what these events imply, that is reported as a finding.
 */
final class MonitorEvent extends PushMonitor implements SessionListener {
    private static final Logger LOG = LoggerFactory.getLogger(MonitorEvent.class);

    private final RoombaSession session;
    private final StateMachine original;
    private final Predicate<String> restartsMove;
    private final Set<String> known = new LinkedHashSet<>();
    private Circumstances circumstances = Circumstances.USUAL;
    private EstimatedActivity activity = EstimatedActivity.STANDBY;

    /**
     * @param original the robot's model
     * @param restartsMove whether this event would restart a running Move
     */
    MonitorEvent(RoombaSession session, StateMachine original, Predicate<String> restartsMove) {
        this.session = session;
        this.original = original;
        this.restartsMove = restartsMove;
        original.triggers().forEach(event -> known.add(event.name()));
        known.retainAll(RobotEvents.FACTS);
        session.addListener(this);
    }

    @Override
    public void pressed(Button button, boolean robotActs) {
        if (robotActs) {
            // The press ends any activity, and is reported as a press.
            activity = EstimatedActivity.ON;
        }
        switch (button) {
            case CLEAN -> press(RobotEvents.CLEAN, robotActs);
            case SPOT -> press(RobotEvents.SPOT, robotActs);
            case DOCK -> press(RobotEvents.DOCK, robotActs);
            case MINUTE, HOUR, DAY, SCHEDULE, CLOCK -> {}
        }
    }

    private void press(String event, boolean robotActs) {
        // A press ends Move, whatever the models say.
        if (known.contains(event) && (robotActs || !restartsMove.test(event))) {
            push(fromPanel(event, robotActs));
        }
    }

    @Override
    public void spotEnded(SpotWatch.SpotEnd how) {
        LOG.debug("spot cleaning has ended: {}", how);
        pushFromDevice(RobotEvents.END_SPOT);
        session.reportSoon();
    }

    @Override
    public void seen(EstimatedActivity now) {
        String event = change(activity, now);
        activity = now;
        if (known.contains(event)) {
            pushFromDevice(event);
            session.reportSoon();
        } else {
            // A robot that shows what it does is awake; its other circumstances are reported once they are certain.
            find(circumstances.asleep() ? Circumstances.USUAL : circumstances);
        }
    }

    /** The event for a change of the robot's own activity; empty if there is none. */
    private String change(EstimatedActivity before, EstimatedActivity now) {
        boolean cleaned = before == EstimatedActivity.CLEAN || before == EstimatedActivity.MAX;
        if (cleaned && now == EstimatedActivity.DOCK) {
            return RobotEvents.SEEK_DOCK;
        }
        if (now != EstimatedActivity.ON || !circumstances.equals(Circumstances.USUAL)) {
            return "";
        }
        return cleaned ? RobotEvents.END_CLEAN : before == EstimatedActivity.DOCK ? RobotEvents.END_DOCK : "";
    }

    @Override
    public void changed(Circumstances before, Circumstances now, EstimatedActivity doing) {
        boolean same =
                RobotEvents.stateName(original, activity, before).equals(RobotEvents.stateName(original, doing, now));
        boolean wasDocked = RobotEvents.isDocked(activity, before);
        activity = doing;
        circumstances = now;
        if (!same) {
            List<String> events = changes(before, wasDocked, now, RobotEvents.isDocked(doing, now));
            events.forEach(this::pushFromDevice);
            if (known.containsAll(events) && !now.asleep()) {
                // A finding must not overtake the work that these events start.
                session.reportSoon();
            } else {
                find(now);
            }
        }
    }

    /**
     * Code that wakes the robot or drives it off its dock reports when that is finished; observations until then are
     * part of it.
     */
    private boolean isBeingMoved() {
        return session.isWaking() || session.isUndocking();
    }

    private void find(Circumstances now) {
        if (isBeingMoved()) {
            return;
        }
        RobotEvents.stateName(original, activity, now).ifPresent(state -> push(foundIn(state)));
    }

    private void pushFromDevice(String event) {
        if (known.contains(event) && !isBeingMoved()) {
            push(fromDevice(event));
        }
    }

    private static List<String> changes(Circumstances before, boolean wasDocked, Circumstances now, boolean isDocked) {
        if (now.asleep()) {
            return List.of(RobotEvents.ASLEEP);
        }
        List<String> changes = new ArrayList<>();
        if (before.asleep()) {
            changes.add(RobotEvents.AWAKE);
        }
        change(changes, before.inTrouble(), now.inTrouble(), RobotEvents.ERROR, RobotEvents.RECOVERED);
        change(changes, wasDocked, isDocked, RobotEvents.DOCKED, RobotEvents.UNDOCKED);
        if (isDocked) {
            // A robot that has just reached its dock is assumed to charge.
            change(changes, !wasDocked || before.filling(), now.filling(), RobotEvents.CHARGING, RobotEvents.CHARGED);
        }
        return changes;
    }

    private static void change(List<String> changes, boolean before, boolean now, String begun, String ended) {
        if (before != now) {
            changes.add(now ? begun : ended);
        }
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return Set.copyOf(known);
    }
}
