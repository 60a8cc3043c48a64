package org.evoloop.link;

import com.fazecast.jSerialComm.SerialPort;

/**
 * Which output of the serial adapter is wired to the device's wake pin, such as a Roomba's BRC. Cables differ: most use RTS,
 * others DTR, and some that should use RTS are miswired.
 *
 * @since 0.1
 */
public enum WakeSignal {
    /** Request to send, the usual one. */
    RTS,
    /** Data terminal ready. */
    DTR,
    /** Both together, for a cable nobody knows. */
    BOTH;

    /** Asserting an output of an adapter with TTL levels pulls its pin low. On a port yet to open: how it starts. */
    boolean drive(SerialPort port, boolean low) {
        return switch (this) {
            case RTS -> low ? port.setRTS() : port.clearRTS();
            case DTR -> low ? port.setDTR() : port.clearDTR();
            case BOTH -> port.setDTRandRTS(low, low);
        };
    }
}
