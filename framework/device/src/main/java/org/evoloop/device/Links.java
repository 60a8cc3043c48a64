package org.evoloop.device;

import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.evoloop.converter.DeviceLink;
import org.evoloop.function.Reading;

/** All connections of a device file as one: it is up while each of them is. */
record Links(List<DeviceLink> all) implements DeviceLink {
    Links {
        all = List.copyOf(all);
    }

    @Override
    public boolean isUp() {
        return all.stream().allMatch(DeviceLink::isUp);
    }

    @Override
    public Optional<Instant> downSince() {
        return all.stream()
                .filter(link -> !link.isUp())
                .flatMap(link -> link.downSince().stream())
                .min(Comparator.naturalOrder());
    }

    @Override
    public List<Reading> readings() {
        return all.stream().flatMap(link -> link.readings().stream()).toList();
    }

    @Override
    public String describe() {
        return all.stream().map(DeviceLink::describe).collect(Collectors.joining("; "));
    }
}
