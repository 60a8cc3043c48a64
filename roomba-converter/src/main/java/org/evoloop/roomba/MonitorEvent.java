package org.evoloop.roomba;

import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.converter.PushMonitor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Monitors the robot: its CLEAN and SPOT buttons, and the end of a spot cleaning. The OI mode tells whether the robot acts
 * on a button by itself or merely reports it.
 */
final class MonitorEvent extends PushMonitor implements SessionListener {
    private static final Logger LOG = LoggerFactory.getLogger(MonitorEvent.class);

    private final Predicate<String> restartsMove;

    /** @param restartsMove whether this event would have a Move that runs begin anew */
    MonitorEvent(RoombaSession session, Predicate<String> restartsMove) {
        this.restartsMove = restartsMove;
        session.addListener(this);
    }

    @Override
    public void pressed(Button button, boolean robotActs) {
        if (button == Button.CLEAN) {
            press(RobotEvents.CLEAN, robotActs);
        } else if (button == Button.SPOT) {
            press(RobotEvents.SPOT, robotActs);
        }
    }

    private void press(String event, boolean robotActs) {
        // A press ends Move, whatever the models say of it.
        if (robotActs || !restartsMove.test(event)) {
            push(fromPanel(event, robotActs));
        }
    }

    @Override
    public void spotEnded(SpotWatch.Ending how) {
        LOG.debug("spot cleaning has ended: {}", how);
        push(fromDevice(RobotEvents.END_SPOT));
    }

    @Override
    public void seen(SeenActivity activity) {
        push(foundIn(RobotEvents.state(activity).name()));
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return Set.of(RobotEvents.CLEAN, RobotEvents.SPOT, RobotEvents.END_SPOT);
    }
}
