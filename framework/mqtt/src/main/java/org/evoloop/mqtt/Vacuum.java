package org.evoloop.mqtt;

import org.evoloop.converter.ConverterStatus;

/**
 * What Home Assistant's vacuum entity shows and operates, of a converter whose device is one.
 *
 * <p>Threading: called on a thread of {@link HomeAssistant}, one call at a time.
 *
 * @since 0.1
 */
public interface Vacuum {

    /** The states that Home Assistant knows. */
    enum Activity {
        /** It cleans, or is on its way to where it will. */
        CLEANING,
        /** It stands on its dock. */
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
    enum Command {
        /** Begin to clean, or go on. */
        START,
        /** End what it does. */
        STOP,
        /** Interrupt what it does. */
        PAUSE,
        /** Drive back to the dock. */
        RETURN_TO_BASE,
        /** Clean a spot. */
        CLEAN_SPOT,
        /** Show where it is. */
        LOCATE
    }

    /** What it does. */
    Activity activity(ConverterStatus status);

    /**
     * Obeys a command; may wait for some seconds.
     *
     * @throws Exception any failure: its message is shown as the reason why the command was refused
     */
    void perform(Command command) throws Exception;
}
