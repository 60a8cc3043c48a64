package org.evoloop.device;

import java.io.IOException;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.function.NewFunction;
import org.jspecify.annotations.Nullable;

/**
 * A connection of a device file, and what the file says about the device and the controller at its other end. It takes
 * one part of the file after another, and {@link #assemble} makes components of them.
 *
 * <p>What a connection cannot do is a mistake in the file, which is what the methods here report.
 *
 * <p>Threading: used by the thread that reads the file.
 *
 * @since 0.1
 */
public abstract class Connection {
    private final String name;
    private final String kind;
    private boolean ofDevice;
    private volatile boolean assembled;

    /**
     * @param name in the file
     * @param kind of {@link ConnectionKind#key}
     */
    protected Connection(String name, String kind) {
        this.name = name;
        this.kind = kind;
    }

    /** Its name in the file. */
    public final String name() {
        return name;
    }

    private void refuse(Section rule, String what) {
        rule.problems().at(rule.node(), "connection " + name + ", of the kind " + kind + ", " + what);
    }

    /**
     * Sends {@code event} to the device.
     *
     * @param how what the file says
     */
    public abstract void send(Node.Text event, Section how);

    /** The key under which a short form, {@code EVENT: TEXT}, is meant; null if there is none. */
    public @Nullable String shortSend() {
        return null;
    }

    /** What tells in which state the device is. */
    public void state(Section rule) {
        refuse(rule, "does not tell in which state the device is");
    }

    /** What tells that the device has done something by itself. */
    public void does(Section rule) {
        refuse(rule, "does not tell what the device does");
    }

    /** What tells that a control of the controller was operated. */
    public void press(Section rule) {
        refuse(rule, "has no controls");
    }

    /** A number or a text that the status shows. */
    public void reading(Node.Text reading, Section rule) {
        refuse(rule, "has no readings");
    }

    /** Notes that the section {@code device} uses this connection; another is only the controller's, or a function's. */
    final void useForDevice() {
        ofDevice = true;
    }

    /** Whether the device cannot be operated without it. */
    final boolean isOfDevice() {
        return ofDevice;
    }

    /** Whatever in the section {@code device} holds for all that is sent over this connection. */
    public void device(Section device) {}

    /**
     * Finds out what becomes of all events that are sent to the device, also over other connections; called before {@link
     * #device}.
     *
     * @param confirmed what the file says
     */
    public void confirms(Section confirmed) {
        refuse(confirmed, "does not tell what became of an event; a connection to a broker does");
    }

    /** Whether a section of the device is for this connection: it names it with {@code key}, or none. */
    protected final boolean isFor(Section section, String key) {
        return section.text(key).map(named -> named.value().equals(name)).orElse(true);
    }

    /** Lets this connection find out what becomes of what this component sends; after {@link #assemble}. */
    public void confirm(EventExecute execute) {
        throw new IllegalStateException(name + " does not tell what became of an event");
    }

    /**
     * Whether it may tell the device's state while an event is still being sent. A learner would take that for the device's
     * own act.
     */
    public boolean tellsWhileSending() {
        return false;
    }

    /** Whether it asks for the device's state without being told to. */
    protected boolean asksByItself() {
        return false;
    }

    /** Something that a function or an effect does over this connection; it must not change the device's state. */
    public @Nullable Outward outward(Section action) {
        refuse(action, "is only for the device's events");
        return null;
    }

    /**
     * A function of a new state that runs at the other end of this connection; run only once the connection has been
     * assembled.
     */
    public @Nullable NewFunction function(Node.Text state, Section section) {
        refuse(section, "runs no functions");
        return null;
    }

    /**
     * The converter is shown in Home Assistant under this name at its broker; called before {@link #assemble}.
     *
     * @param id of the converter there, by which a connection knows what is its own
     */
    public void shownAs(String id) {}

    /** Whether it is only played: nothing is ever sent over it, since no components have been made. */
    public final boolean isPlayed() {
        return !assembled;
    }

    /**
     * Makes the components for this converter; nothing is sent or asked before {@link Parts#open}.
     *
     * @throws IOException if this computer lacks what it takes; the message says what to do
     */
    public final Parts assemble(SystemEventConverter converter) throws IOException {
        assembled = true;
        return make(converter);
    }

    /**
     * As {@link #assemble}, with a simulation of what is at the other end; null if there is none, and the original model
     * plays the device.
     */
    public final @Nullable Parts simulate(SystemEventConverter converter) throws IOException {
        Parts simulated = makeSimulated(converter);
        assembled = simulated != null;
        return simulated;
    }

    /** As {@link #simulate}. */
    protected @Nullable Parts makeSimulated(SystemEventConverter converter) throws IOException {
        return null;
    }

    /** As {@link #assemble}. */
    protected abstract Parts make(SystemEventConverter converter) throws IOException;
}
