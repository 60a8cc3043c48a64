package org.evoloop.converter.changing;

import org.evoloop.converter.ConverterDelegate;
import org.evoloop.loop.LoopConfig;

/** Provides the delegates of {@code SystemEventConverter}. */
public final class Delegates implements ConverterDelegate.Maker {
    /** For the service loader. */
    public Delegates() {}

    @Override
    public ConverterDelegate make(LoopConfig config) {
        return new Converter(config);
    }
}
