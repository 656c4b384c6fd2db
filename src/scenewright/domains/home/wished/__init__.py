"""What a household wishes: things, places, outlets within reach; whether it is met."""
