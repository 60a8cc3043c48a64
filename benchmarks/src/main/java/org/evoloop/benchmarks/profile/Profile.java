package org.evoloop.benchmarks.profile;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import jdk.jfr.consumer.RecordedClass;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordedFrame;
import jdk.jfr.consumer.RecordedMethod;
import jdk.jfr.consumer.RecordedStackTrace;
import jdk.jfr.consumer.RecordedThread;
import jdk.jfr.consumer.RecordingFile;

/**
 * What Flight Recorder has sampled: the methods that threads were in, and what was allocated where. It samples only
 * threads that run Java code, not threads that sleep, yield or are in the kernel.
 *
 * <p>Threading: immutable.
 *
 * @param load how much of the machine's processors the process used
 * @param samples the number of samples for each call stack
 * @param allocations estimated bytes of each class, by place
 */
public record Profile(Load load, Map<Stack, Long> samples, Map<Allocation, Long> allocations) {
    static final String SAMPLE = "jdk.ExecutionSample";
    static final String ALLOCATION = "jdk.ObjectAllocationSample";
    static final String LOAD = "jdk.CPULoad";
    private static final String MEASURING = Recorder.class.getName() + ".repeat";
    private static final String RECORDING = Recorder.class.getName() + ".record";

    /** The names in class files. */
    private static final Map<String, String> PRIMITIVES = Map.of(
            "Z", "boolean", "B", "byte", "C", "char", "S", "short", "I", "int", "J", "long", "F", "float", "D",
            "double");

    /**
     * Shares of all the machine's processors, from 0 to 1: in the process's own code, and in the kernel on its behalf.
     */
    public record Load(double user, double kernel) {}

    /**
     * A call stack.
     *
     * @param thread the thread's name without its number
     * @param methods such as {@code org.evoloop.loop.Monitor.run}, from the measured work, or else the thread's first
     *     method, to the innermost one
     */
    public record Stack(String thread, List<String> methods) {
        public Stack {
            methods = List.copyOf(methods);
        }
    }

    /** Instances of {@code type} created in {@code method}, which is Evoloop's own if there is one on the stack. */
    public record Allocation(String type, String method) {}

    public Profile {
        samples = Collections.unmodifiableMap(new LinkedHashMap<>(samples));
        allocations = Collections.unmodifiableMap(new LinkedHashMap<>(allocations));
    }

    /** Reads a recording of {@link Recorder}. */
    public static Profile read(Path recording) throws IOException {
        Map<Stack, Long> samples = new LinkedHashMap<>();
        Map<Allocation, Long> allocations = new LinkedHashMap<>();
        double user = 0;
        double kernel = 0;
        long loads = 0;
        try (RecordingFile events = new RecordingFile(recording)) {
            while (events.hasMoreEvents()) {
                RecordedEvent event = events.readEvent();
                List<String> methods = methods(event);
                if (methods.contains(RECORDING)) {
                    continue;
                }
                switch (event.getEventType().getName()) {
                    case SAMPLE -> samples.merge(stack(event, methods), 1L, Long::sum);
                    case ALLOCATION ->
                        allocations.merge(allocation(event, methods), event.getLong("weight"), Long::sum);
                    case LOAD -> {
                        user += event.getFloat("jvmUser");
                        kernel += event.getFloat("jvmSystem");
                        loads++;
                    }
                    default -> {
                        // Events about Flight Recorder itself are ignored.
                    }
                }
            }
        }
        long count = Math.max(1, loads);
        return new Profile(new Load(user / count, kernel / count), samples, allocations);
    }

    private static Stack stack(RecordedEvent event, List<String> methods) {
        RecordedThread thread = event.getThread("sampledThread");
        return new Stack(thread.getJavaName().replaceFirst("-[0-9]+$", ""), methods);
    }

    private static Allocation allocation(RecordedEvent event, List<String> methods) {
        String method = methods.isEmpty() ? "?" : methods.get(methods.size() - 1);
        for (String candidate : methods) {
            method = candidate.startsWith("org.evoloop.") ? candidate : method;
        }
        return new Allocation(type(event.getClass("objectClass")), method);
    }

    /** Without the methods outside the measured work, which are always the same. */
    private static List<String> methods(RecordedEvent event) {
        List<String> methods = new ArrayList<>();
        RecordedStackTrace trace = event.getStackTrace();
        if (trace != null) {
            for (RecordedFrame frame : trace.getFrames()) {
                methods.add(name(frame.getMethod()));
            }
        }
        Collections.reverse(methods);
        return methods.subList(methods.lastIndexOf(MEASURING) + 1, methods.size());
    }

    private static String name(RecordedMethod method) {
        return plain(method.getType().getName()) + "." + method.getName();
    }

    private static String type(RecordedClass type) {
        String name = type.getName();
        int dimensions = name.lastIndexOf('[') + 1;
        String element = name.substring(dimensions);
        if (dimensions == 0) {
            return plain(name);
        }
        String plain = element.startsWith("L")
                ? plain(element.substring(1, element.length() - 1))
                : PRIMITIVES.getOrDefault(element, element);
        return plain + "[]".repeat(dimensions);
    }

    /** Without the random numbers in the names of generated classes. */
    private static String plain(String className) {
        return className.replace('/', '.').replaceFirst("(?<=\\$\\$Lambda).*|[+.]0x.*", "");
    }

    /** The number of samples. */
    public long sampleCount() {
        return samples.values().stream().mapToLong(Long::longValue).sum();
    }
}
