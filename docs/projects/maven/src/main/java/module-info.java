/** A lamp with a second light. */
module com.example.lamp {
    requires org.evoloop.core;
}
