package org.evoloop.link;

import com.fazecast.jSerialComm.SerialPort;

/**
 * The output of the serial adapter that is wired to the device's wake pin, such as a Roomba's BRC. Cables differ: most
 * use RTS, others DTR, and some that should use RTS are miswired.
 *
 * @since 0.1
 */
public enum WakeSignal {
    /** Request to send, the usual one. */
    RTS,
    /** Data terminal ready. */
    DTR,
    /** Both together, for a cable with unknown wiring. */
    BOTH;

    /**
     * Drives the output. Asserting an output of an adapter with TTL levels pulls its pin low. On a port that is not
     * open yet, sets the initial level.
     */
    boolean drive(SerialPort port, boolean low) {
        return switch (this) {
            case RTS -> low ? port.setRTS() : port.clearRTS();
            case DTR -> low ? port.setDTR() : port.clearDTR();
            case BOTH -> port.setDTRandRTS(low, low);
        };
    }
}
