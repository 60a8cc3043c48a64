package org.evoloop.device;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.SystemEventConverter;

/** Adds the parts of a file's connections to a converter. */
final class Wiring {
    private Wiring() {}

    /**
     * Adds all of them, with their links as one.
     *
     * @param each gets the parts of each connection, which it opens and closes
     * @return the links
     * @throws IOException if this computer lacks what it takes
     */
    static List<DeviceLink> add(DeviceFile file, SystemEventConverter converter, Consumer<Parts> each)
            throws IOException {
        return add(file, converter, each, connection -> true);
    }

    /** As {@link #add}, for a converter whose link consists of those of the connections that the device needs. */
    static void addForDevice(DeviceFile file, SystemEventConverter converter, Consumer<Parts> each) throws IOException {
        add(file, converter, each, Connection::isOfDevice);
    }

    private static List<DeviceLink> add(
            DeviceFile file, SystemEventConverter converter, Consumer<Parts> each, Predicate<Connection> isShown)
            throws IOException {
        Map<Connection, Parts> all = new LinkedHashMap<>();
        for (Connection connection : file.connections()) {
            Parts parts = connection.assemble(converter);
            // First, so that they are closed if what follows fails.
            each.accept(parts);
            all.put(connection, parts);
        }
        Connection confirming = file.confirming();
        if (confirming != null) {
            all.replaceAll((connection, parts) -> connection == confirming ? parts : confirmedBy(confirming, parts));
        }
        all.replaceAll((connection, parts) -> isShown.test(connection) ? parts : parts.withoutLink());
        return add(all.values(), converter);
    }

    /** Parts whose components send for another connection's. */
    private static Parts confirmedBy(Connection confirming, Parts parts) {
        parts.executes().forEach(confirming::confirm);
        return new Parts(parts.monitors(), List.of(), parts.link(), parts.open(), parts.close(), parts.commands());
    }

    /** As {@link #add}, of connections that simulate what is at their other end; empty if none does. */
    static Optional<List<DeviceLink>> simulate(DeviceFile file, SystemEventConverter converter, Consumer<Parts> each)
            throws IOException {
        List<Parts> all = new ArrayList<>();
        for (Connection connection : file.connections()) {
            Parts parts = connection.simulate(converter);
            if (parts != null) {
                each.accept(parts);
                all.add(parts);
            }
        }
        return all.isEmpty() ? Optional.empty() : Optional.of(add(all, converter));
    }

    private static List<DeviceLink> add(Collection<Parts> all, SystemEventConverter converter) {
        List<DeviceLink> links = new ArrayList<>();
        for (Parts parts : all) {
            parts.monitors().forEach(converter::addMonitor);
            parts.executes().forEach(converter::addExecute);
            if (parts.link() != null) {
                links.add(parts.link());
            }
        }
        if (!links.isEmpty()) {
            converter.addLink(links.size() == 1 ? links.get(0) : new Links(links));
        }
        return links;
    }
}
