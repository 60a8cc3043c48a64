package org.evoloop.device;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;

/**
 * A running converter of a device file with other models, and without the file's functions: for programs that work with the
 * device itself.
 *
 * <p>Threading: opened and closed by one thread.
 *
 * @since 0.1
 */
public final class DeviceConverter implements AutoCloseable {
    private final SystemEventConverter converter;
    private final List<Runnable> closing = new ArrayList<>();

    private DeviceConverter(DeviceFile file, Clock clock) {
        converter = new SystemEventConverter(LoopConfig.defaults(file.name(), clock));
    }

    /**
     * Opens all connections of a file; it does not wait for the other end. The converter's link has only those that the
     * section {@code device} uses: whoever operates the device need not wait for its controller.
     *
     * @param models that the converter has
     * @param monitor through which events are pressed
     * @param analyze decides
     * @param execute a further component
     * @throws IOException if this computer lacks what it takes
     */
    public static DeviceConverter open(
            DeviceFile file,
            ModelPair models,
            Clock clock,
            EventMonitor monitor,
            EventAnalyze analyze,
            EventExecute execute)
            throws IOException {
        DeviceConverter opened = new DeviceConverter(file, clock);
        try {
            opened.converter.addAnalyze(analyze);
            opened.connect(file, models, monitor, execute);
            return opened;
        } catch (IOException | RuntimeException failed) {
            opened.close();
            throw failed;
        }
    }

    private void connect(DeviceFile file, ModelPair models, EventMonitor monitor, EventExecute execute)
            throws IOException {
        converter.addMonitor(monitor);
        List<Parts> all = new ArrayList<>();
        Wiring.addForDevice(file, converter, parts -> {
            closing.add(parts.close());
            all.add(parts);
        });
        converter.addExecute(execute);
        converter.addKnowledge(new StateKnowledge(models));
        converter.build();
        for (Parts parts : all) {
            parts.open().open();
        }
        converter.start();
    }

    /** The converter, which runs. */
    public SystemEventConverter converter() {
        return converter;
    }

    /** Ends the converter and its connections. */
    @Override
    public void close() {
        converter.close();
        closing.forEach(Runnable::run);
    }
}
