package org.evoloop.mqtt;

import java.util.EnumSet;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;

/**
 * The vacuum entity of Home Assistant, for a converter whose device is a vacuum.
 *
 * <p>Threading: called on a thread of {@link HomeAssistant}, one call at a time.
 *
 * @since 0.1
 */
public interface Vacuum {

    /** The states that Home Assistant knows. */
    enum Activity {
        /** It cleans, or is on its way to a place to clean. */
        CLEANING,
        /** It is on its dock. */
        DOCKED,
        /** It has paused. */
        PAUSED,
        /** It does nothing. */
        IDLE,
        /** It drives back to its dock. */
        RETURNING,
        /** Something is wrong with it. */
        ERROR
    }

    /** The commands that Home Assistant gives, by their usual payloads. */
    enum Order {
        /** Start or resume cleaning. */
        START,
        /** Stop. */
        STOP,
        /** Pause. */
        PAUSE,
        /** Drive back to the dock. */
        RETURN_TO_BASE,
        /** Clean a spot. */
        CLEAN_SPOT,
        /** Show where it is. */
        LOCATE
    }

    /** The vacuum's activity. */
    Activity activity(ConverterStatus status);

    /**
     * The commands that Home Assistant offers: those that the new model can carry out. Asked again when other models
     * have taken over.
     */
    default Set<Order> commands() {
        return EnumSet.allOf(Order.class);
    }

    /**
     * Executes a command; may block for some seconds.
     *
     * @throws Exception any failure: its message is shown as the reason why the command was refused
     */
    void perform(Order command) throws Exception;
}
